// SPDX-License-Identifier: BSD-3-Clause
#include "planners/TipCells.h"

#include <algorithm>
#include <cmath>

namespace narrows
{
namespace
{
constexpr double edgePart = 0.9;  ///< of the choices that are made among cells at the edge
constexpr double penalty = 0.5;   ///< on the score of a cell from which a step has led nowhere
}  // namespace

TipCells::Coordinates TipCells::coordinates(const ob::State *state) const
{
    Eigen::VectorXi cell(projection_->getDimension());
    projection_->computeCoordinates(state, cell);
    Coordinates result{};
    std::copy_n(cell.data(), std::min<Eigen::Index>(cell.size(), 3), result.begin());
    return result;
}

template <class Call>
void TipCells::forNeighbours(Coordinates coordinates, const Call &call)
{
    for (std::size_t axis = 0; axis < std::min<std::size_t>(projection_->getDimension(), 3); ++axis)
        for (const int shift : {-1, 1})
        {
            coordinates[axis] += shift;
            const auto found = cells_.find(coordinates);
            coordinates[axis] -= shift;
            if (found != cells_.end())
                call(found->second);
        }
}

void TipCells::add(const ob::State *state)
{
    const Coordinates coordinates = this->coordinates(state);
    const auto [found, isNew] = cells_.try_emplace(coordinates);
    Cell &cell = found->second;
    cell.nodes.push_back(size_++);
    if (!isNew)
        return;
    cell.score = 1.0 + std::log(1.0 + rounds_);
    forNeighbours(coordinates,
                  [&cell](Cell &other)
                  {
                      ++cell.neighbours;
                      ++other.neighbours;
                  });
}

bool TipCells::isInner(const Cell &cell) const
{
    return cell.neighbours >= 2 * static_cast<int>(projection_->getDimension());
}

double TipCells::importance(const Cell &cell) const
{
    return cell.score / ((1.0 + cell.neighbours) * static_cast<double>(cell.nodes.size()) * cell.visits);
}

int TipCells::lateNode(const Cell &cell, ompl::RNG &random)
{
    return cell.nodes[static_cast<std::size_t>(random.halfNormalInt(0, static_cast<int>(cell.nodes.size()) - 1))];
}

int TipCells::choose(ompl::RNG &random)
{
    ++rounds_;
    const bool atEdge = random.uniform01() < edgePart;
    std::array<Cell *, 2> best{};  // of those at the edge, of the others
    for (auto &[coordinates, cell] : cells_)
    {
        Cell *&kind = best[isInner(cell) ? 1 : 0];
        if (kind == nullptr || importance(cell) > importance(*kind))
            kind = &cell;
    }
    chosen_ = best[atEdge ? 0 : 1] != nullptr ? best[atEdge ? 0 : 1] : best[atEdge ? 1 : 0];
    ++chosen_->visits;
    return lateNode(*chosen_, random);
}

void TipCells::blame()
{
    chosen_->score *= penalty;
}

int TipCells::at(const ob::State *state, ompl::RNG &random) const
{
    const auto found = cells_.find(coordinates(state));
    return found == cells_.end() ? -1 : lateNode(found->second, random);
}
}  // namespace narrows
