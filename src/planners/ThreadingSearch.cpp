// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ThreadingSearch.h"

#include <algorithm>
#include <cmath>

namespace narrows
{
namespace
{
constexpr double firstSlide = 0.1;  ///< radians
constexpr int mostDraws = 100;      ///< of a step whose end is free
constexpr int mostRedraws = 8;      ///< of the links from one on, before all of them are drawn anew
constexpr double twoPi = boost::math::constants::two_pi<double>();

double *valuesOf(ob::State *state)
{
    return state->as<ob::RealVectorStateSpace::StateType>()->values;
}
}  // namespace

ThreadingSearch::ThreadingSearch(const ob::SpaceInformationPtr &si, const JointChart &chart,
                                 std::function<std::unique_ptr<const GapEquations>()> midGap,
                                 std::unique_ptr<Overlap> collision, const Centring &centring)
  : si_(si),
    chart_(chart),
    makeMidGap_(std::move(midGap)),
    centring_(centring),
    collision_(std::move(collision)),
    slices_{Eigen::VectorXd::Zero(chart.dimension()), Eigen::MatrixXd(chart.dimension(), 0)},
    trees_{ThreadingTree(chart.periods()), ThreadingTree(chart.periods())},
    slideStep_{firstSlide, firstSlide},
    from_(si),
    to_(si)
{
}

const Eigen::VectorXd &ThreadingSearch::root(int side, int number) const
{
    return tree(side)[rootsOf(side)[static_cast<std::size_t>(number)].node].x;
}

void ThreadingSearch::setSlices(AffineSlices slices)
{
    slices_ = std::move(slices);
    for (ThreadingTree &tree : trees_)
        tree.reslice(slices_.dimensions(), [this](const Eigen::VectorXd &x) { return coordinates(x); });
}

Eigen::VectorXd ThreadingSearch::coordinates(const Eigen::VectorXd &x) const
{
    return slices_.coordinates(x);
}

void ThreadingSearch::addRoot(int side, const ob::State *state)
{
    Eigen::VectorXd x;
    chart_.read(state, x);
    std::vector<Root> &roots = roots_[static_cast<std::size_t>(side)];
    const bool first = roots.empty();
    // The first goal takes the turns that make it nearest to the first start: slices hold the line between them.
    if (side == 1 && first && this->roots(0) > 0)
    {
        chart_.shortWay(root(0, 0), x, direction_);
        x = root(0, 0) + direction_;
    }
    const int level = first ? 1 : static_cast<int>(chart_.dimension());
    const int number = static_cast<int>(roots.size());
    roots.push_back({ob::ScopedState<>(si_), treeOf(side).add(x, -1 - number, level, coordinates(x), true)});
    si_->copyState(roots.back().state.get(), state);
}

void ThreadingSearch::write(int side, int node, ob::State *state) const
{
    const ThreadingTree::Node &it = tree(side)[node];
    if (it.parent < 0)
        si_->copyState(state, rootsOf(side)[static_cast<std::size_t>(-1 - it.parent)].state.get());
    else
        chart_.write(it.x, valuesOf(state));
}

int ThreadingSearch::nearest(int side, const Stride &stride, const Eigen::VectorXd &x) const
{
    if (stride.dimension == 0)
        return tree(side).nearest(x);
    return tree(side).nearestInSlice(slices_.basis.leftCols(stride.dimension).transpose() * (x - slices_.origin));
}

bool ThreadingSearch::goStraight(int start, int goal)
{
    const Root &from = rootsOf(0)[static_cast<std::size_t>(start)], &to = rootsOf(1)[static_cast<std::size_t>(goal)];
    chart_.shortWay(root(0, start), root(1, goal), direction_);
    if (meetsObstacle(root(0, start), direction_) || !si_->checkMotion(from.state.get(), to.state.get()))
        return false;
    meeting_ = {from.node, to.node};
    return true;
}

bool ThreadingSearch::grow(const Stride &stride, const Eigen::VectorXd &sample, ompl::RNG &random,
                           const ob::PlannerTerminationCondition &ptc)
{
    ++counts_.samples;
    const int side = turn_;
    turn_ = 1 - side;
    const int nearestNode = nearest(side, stride, sample);
    Way way{side, nearestNode, -1, sample, stride};
    while (advance(way, random) == Progress::Advanced && way.sliding && !ptc)
        ;
    listLast(way);
    if (way.node == nearestNode)
        return false;
    const ThreadingTree::Node &reached = tree(side)[way.node];
    Stride back = stride;
    if (reached.level > stride.dimension)
        back.dimension = 0;  // it has left the slice
    return answer(way, nearest(turn_, back, reached.x), back, random, ptc);
}

bool ThreadingSearch::explore(double range, ompl::RNG &random, const ob::PlannerTerminationCondition &ptc)
{
    ++counts_.samples;
    const int side = turn_;
    turn_ = 1 - side;
    const int node = cellsOf(side).choose(random);
    Stride stride;
    stride.bends = false;
    Way way{side, node, -1, tree(side)[node].x, stride};
    way.isGiven = way.isPlain = true;
    if (drawStep(tree(side)[node].x, range, random))
    {
        way.goal = next_;
        if (stepStraight(way, true) == Progress::Trapped)
        {
            way.goal = tree(side)[node].x + 0.5 * direction_;
            stepStraight(way);
        }
    }
    if (way.node == node)
    {
        cells_[static_cast<std::size_t>(side)]->blame();
        return false;
    }
    write(side, way.node, to_.get());
    const int near = cellsOf(turn_).at(to_.get(), random);
    return near >= 0 && answer(way, near, stride, random, ptc);
}

bool ThreadingSearch::drawStep(const Eigen::VectorXd &from, double range, ompl::RNG &random)
{
    const double reach = range / std::sqrt(static_cast<double>(from.size()));
    turning_.resize(from.size());
    bool ofTurns = false;
    int first = 0;  // the links of the joints before it are free where these have turned them
    for (int draw = 0, redraws = 0; draw < mostDraws; ++draw)
    {
        ++counts_.draws;
        if (first == 0)
            ofTurns = random.uniformBool();
        for (Eigen::Index j = first; j < turning_.size(); ++j)
            turning_[j] =
                reach * std::min(1.0, (chart_.upper()[j] - chart_.lower()[j]) / twoPi) * random.uniformReal(-1.0, 1.0);
        if (ofTurns)
            chart_.wayOfTurns(turning_, direction_);
        else
            direction_ = turning_;
        const double part = chart_.unambiguousPart(direction_);
        next_ = from + part * direction_;
        chart_.enforceLimits(next_);
        const int met = firstMet(next_, part < 1.0 ? 0 : first);
        if (met < 0)
        {
            chart_.write(next_, valuesOf(to_.get()));
            if (si_->isValid(to_.get()))
                return true;
        }
        redraws = met > first ? 0 : redraws + 1;
        first = part < 1.0 || redraws >= mostRedraws ? 0 : std::max(met, 0);
    }
    return false;
}

TipCells &ThreadingSearch::cellsOf(int side)
{
    std::optional<TipCells> &cells = cells_[static_cast<std::size_t>(side)];
    if (!cells)
        cells.emplace(si_->getStateSpace()->getDefaultProjection());
    while (cells->size() < tree(side).size())
    {
        write(side, cells->size(), from_.get());
        cells->add(from_.get());
    }
    return *cells;
}

bool ThreadingSearch::answer(const Way &way, int from, const Stride &stride, ompl::RNG &random,
                             const ob::PlannerTerminationCondition &ptc)
{
    Way answer{1 - way.side, from, way.node, tree(way.side)[way.node].x, stride};
    answer.isPlain = way.isPlain;
    Progress progress = advance(answer, random);
    while (progress == Progress::Advanced && !ptc)
        progress = advance(answer, random);
    listLast(answer);
    if (progress != Progress::Reached)
    {
        const double distance = (tree(way.side)[way.node].x - tree(answer.side)[answer.node].x).norm();
        leastDistance_ = std::min(leastDistance_, distance);
        return false;
    }
    meeting_ = way.side == 0 ? std::pair(way.node, answer.node) : std::pair(answer.node, way.node);
    return true;
}

std::shared_ptr<og::PathGeometric> ThreadingSearch::path() const
{
    auto path = std::make_shared<og::PathGeometric>(si_);
    std::vector<ob::State *> &states = path->getStates();
    const auto append = [&](int side, int last)
    {
        for (int node = last; node >= 0; node = tree(side)[node].parent)
        {
            states.push_back(si_->allocState());
            write(side, node, states.back());
        }
    };
    append(0, meeting_.first);
    std::reverse(states.begin(), states.end());
    append(1, meeting_.second);
    return path;
}
}  // namespace narrows
