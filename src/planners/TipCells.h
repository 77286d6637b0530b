// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <vector>

#include <ompl/base/ProjectionEvaluator.h>
#include <ompl/util/RandomNumbers.h>

#include "spaces/Ompl.h"

namespace narrows
{
/// Nodes of a tree by the cell of a grid in which the robot's tip lies, and which cell is worth growing from next: one
/// at the edge of what has been reached, with few nodes and few visits (the importance of KPIECE: Sucan and Kavraki,
/// A sampling-based tree planner for systems with complex dynamics, T-RO 2012).
class TipCells
{
public:
    /// \param projection into two or three dimensions, with the sides of the cells
    explicit TipCells(ob::ProjectionEvaluatorPtr projection);

    /// How many nodes have been added: the next one's number.
    int size() const { return size_; }
    void add(const ob::State *state);  ///< The next node, by its state.

    /// A node of the cell that matters most; now and then of one that is not at the edge. \pre size() > 0
    int choose(ompl::RNG &random);
    /// Growing from the node last chosen has led nowhere.
    void blame();

    /// A node in the cell that holds this state, most likely a late one; -1 if it is empty.
    int at(const ob::State *state, ompl::RNG &random) const;

private:
    using Coordinates = std::array<int, 3>;
    struct Cell
    {
        std::vector<int> nodes;
        double score;
        double visits = 1.0;
        int neighbours = 0;
        double importance = 0.0;  ///< which follows from the others; kept, as every choice asks all cells for it
    };

    Coordinates coordinates(const ob::State *state) const;
    bool isInner(const Cell &cell) const { return cell.neighbours >= 2 * dimension_; }
    static void weigh(Cell &cell);  ///< anew, after a change
    static int lateNode(const Cell &cell, ompl::RNG &random);
    /// Tells the cell at these coordinates and those beside it of each other.
    void introduce(std::size_t cell, Coordinates coordinates);

    ob::ProjectionEvaluatorPtr projection_;
    int dimension_;  ///< of cells
    std::vector<Cell> cells_;
    std::map<Coordinates, std::size_t> places_;  ///< of them
    std::size_t chosen_ = 0;
    int size_ = 0, rounds_ = 0;
};
}  // namespace narrows
