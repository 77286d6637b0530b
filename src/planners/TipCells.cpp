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

TipCells::TipCells(ob::ProjectionEvaluatorPtr projection)
  : projection_(std::move(projection)), dimension_(std::min(static_cast<int>(projection_->getDimension()), 3))
{
}

TipCells::Coordinates TipCells::coordinates(const ob::State *state) const
{
    Eigen::VectorXi cell(projection_->getDimension());
    projection_->computeCoordinates(state, cell);
    Coordinates result{};
    std::copy_n(cell.data(), dimension_, result.begin());
    return result;
}

void TipCells::introduce(std::size_t cell, Coordinates coordinates)
{
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
        for (const int shift : {-1, 1})
        {
            coordinates[axis] += shift;
            const auto found = places_.find(coordinates);
            coordinates[axis] -= shift;
            if (found == places_.end())
                continue;
            ++cells_[cell].neighbours;
            ++cells_[found->second].neighbours;
            weigh(cells_[found->second]);
        }
}

void TipCells::add(const ob::State *state)
{
    const Coordinates coordinates = this->coordinates(state);
    const auto [found, isNew] = places_.try_emplace(coordinates, cells_.size());
    const std::size_t cell = found->second;
    if (isNew)
    {
        cells_.push_back({{}, 1.0 + std::log(1.0 + rounds_)});
        introduce(cell, coordinates);
    }
    cells_[cell].nodes.push_back(size_++);
    weigh(cells_[cell]);
}

void TipCells::weigh(Cell &cell)
{
    cell.importance = cell.score / ((1.0 + cell.neighbours) * static_cast<double>(cell.nodes.size()) * cell.visits);
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
    for (Cell &cell : cells_)
    {
        Cell *&kind = best[isInner(cell) ? 1 : 0];
        if (kind == nullptr || cell.importance > kind->importance)
            kind = &cell;
    }
    Cell &chosen = *(best[atEdge ? 0 : 1] != nullptr ? best[atEdge ? 0 : 1] : best[atEdge ? 1 : 0]);
    chosen_ = static_cast<std::size_t>(&chosen - cells_.data());
    ++chosen.visits;
    weigh(chosen);
    return lateNode(chosen, random);
}

void TipCells::blame()
{
    cells_[chosen_].score *= penalty;
    weigh(cells_[chosen_]);
}

int TipCells::at(const ob::State *state, ompl::RNG &random) const
{
    const auto found = places_.find(coordinates(state));
    return found == places_.end() ? -1 : lateNode(cells_[found->second], random);
}
}  // namespace narrows
