// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "kernel/chain/ChainCertificate.h"
#include "kernel/fields/CorridorClasses.h"

namespace narrows
{
/// Where the middle path comes from.
enum class TightField
{
    Corridor,  ///< the cheapest path, clearance being cheap
    Laplace    ///< the paper's potential
};

/// Of the grid that middle paths are looked for on.
struct TightGrid
{
    TightField field = TightField::Corridor;  ///< where middle paths come from
    double spacing = 0.0;  ///< 0: a twelfth of a link in space, a fortieth in the plane, if that is not too many cells
    int corridors = 12;    ///< >= 1, how many are looked for at most
    int refinements = 2;   ///< >= 0, how often the grid is refined if there is no way through it
};

/// A middle path, windowed.
template <int D>
struct TightWay
{
    PointPath<D> middle;  ///< its nodes
    double width;         ///< of its corridor, typically
};

/// Middle paths from the start of a chain's tip to its goal.
template <int D>
class TightWays
{
public:
    using Point = Eigen::Matrix<double, D, 1>;        ///< of the plane or of space
    using AlignedBox = Eigen::AlignedBox<double, D>;  ///< of the grid

    /// Obstacles, spec and settings are referred to.
    TightWays(const ChordObstacles<D> &obstacles, const ChainSpec &spec, const TightGrid &settings);

    /// The cheapest way, on the coarsest grid that has one.
    /// \return why there is none ("no_corridor", a failure of the grid or of the field); empty if there is one
    std::string findFirst(const Point &start, const Point &goal);

    /// Whether it is worth looking for further ways.
    bool hasMore() const;
    /// Looks for another way, from the second one on on a finer grid if the cheapest comes to places hardly wider than
    /// the cells. False if none has been found, or `stop` said so: then there may be more.
    bool findAnother(const std::function<bool()> &stop);

    const std::vector<TightWay<D>> &found() const { return ways_; }  ///< in the order in which they were found
    /// cells, corridors.
    const std::map<std::string, double> &counts() const { return counts_; }

private:
    AlignedBox extent(double share) const;
    std::string open(const AlignedBox &extent, double spacing);
    std::string corridor(const std::function<bool()> &stop = {});
    std::string laplace();
    void refine();
    void add(const PointPath<D> &path);

    const ChordObstacles<D> &obstacles_;
    const ChainSpec &spec_;
    const TightGrid &settings_;
    Point start_, goal_;
    std::map<std::string, double> counts_;
    VoxelGrid<D> grid_;
    std::vector<float> clearance_;
    std::unique_ptr<CorridorClasses<D>> classes_;  ///< on the grid
    double narrowest_ = 0.0;                       ///< clearance of the cheapest corridor
    std::vector<TightWay<D>> ways_;
    bool refined_ = false;
    int vain_ = 0;  ///< searches since the last way was found
};

extern template class TightWays<2>;
extern template class TightWays<3>;
}  // namespace narrows
