// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// A tree of configurations in flat arrays, whose nodes can be looked up in all of joint space or in one of its nested
/// slices (AffineSlices).
class ThreadingTree
{
public:
    struct Node
    {
        Eigen::VectorXd x;  ///< in a JointChart
        int parent;         ///< negative: a root, number -1 - parent
        int level;          ///< dimension of the least slice that is known to hold it
    };

    /// \param periods of the coordinates, +infinity where there is none
    /// \param coordinates of a node in slices that are kept with it
    ThreadingTree(const Eigen::VectorXd &periods, int coordinates);

    /// \param coordinates in slices; at least as many as the tree keeps
    /// \param listed whether nearest() shall find it
    int add(const Eigen::VectorXd &x, int parent, int level, const Eigen::VectorXd &coordinates, bool listed);
    void list(int node, const Eigen::VectorXd &coordinates);

    const Node &operator[](int node) const { return nodes_[static_cast<std::size_t>(node)]; }
    int size() const { return static_cast<int>(nodes_.size()); }

    /// The listed node that is the least way from x, the short way round; -1 without nodes.
    int nearest(const Eigen::VectorXd &x) const;
    /// The same in the slice of as many dimensions as there are coordinates, among the nodes that it is known to hold.
    int nearestInSlice(const Eigen::VectorXd &coordinates) const;

private:
    Eigen::VectorXd periods_;
    int coordinateCount_;
    std::vector<Node> nodes_;
    std::vector<int> listed_;      ///< nodes
    std::vector<double> wrapped_;  ///< per listed node its coordinates in one period
    std::vector<double> slices_;   ///< per listed node its coordinates in slices
};
}  // namespace narrows
