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
    /// A configuration, and how the tree has come to it.
    struct Node
    {
        Eigen::VectorXd x;  ///< in a JointChart
        int parent;         ///< negative: a root, number -1 - parent
        int level;          ///< dimension of the least slice that is known to hold it
    };

    /// \param periods of the coordinates, +infinity where there is none
    explicit ThreadingTree(const Eigen::VectorXd &periods) : periods_(periods) {}

    /// Adds a node. \param x, parent, level as in Node
    /// \param coordinates in slices; at least as many as the tree keeps
    /// \param listed whether nearest() shall find it \return its index
    int add(const Eigen::VectorXd &x, int parent, int level, const Eigen::VectorXd &coordinates, bool listed);
    /// From now on nearest() finds this node. \pre it did not \param node, coordinates as in add()
    void list(int node, const Eigen::VectorXd &coordinates);
    /// Keeps the coordinates of other slices from now on. \param count of coordinates
    /// \param coordinates yields those of a place
    template <class Coordinates>
    void reslice(int count, const Coordinates &coordinates)
    {
        coordinateCount_ = count;
        slices_.clear();
        for (const int node : listed_)
            append(coordinates((*this)[node].x));
    }

    /// \pre 0 <= node < size()
    const Node &operator[](int node) const { return nodes_[static_cast<std::size_t>(node)]; }
    int size() const { return static_cast<int>(nodes_.size()); }  ///< number of nodes

    /// The listed node that is the least way from x, the short way round; -1 without nodes.
    int nearest(const Eigen::VectorXd &x) const;
    /// The same in the slice of as many dimensions as there are coordinates, among the nodes that it is known to hold.
    int nearestInSlice(const Eigen::VectorXd &coordinates) const;

private:
    void append(const Eigen::VectorXd &coordinates)
    {
        slices_.insert(slices_.end(), coordinates.data(), coordinates.data() + coordinateCount_);
    }

    Eigen::VectorXd periods_;
    int coordinateCount_ = 0;
    std::vector<Node> nodes_;
    std::vector<int> listed_;      ///< nodes
    std::vector<double> wrapped_;  ///< per listed node its coordinates in one period
    std::vector<double> slices_;   ///< per listed node its coordinates in slices
};
}  // namespace narrows
