// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/VoxelGrid.h"

#include <gtest/gtest.h>

#include "TightScenes.h"
#include "kernel/SegmentDistance.h"
#include "kernel/SpatialDistance.h"
#include "kernel/SuperellipseGeometry.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(VoxelGrid, CoversItsBoundsWithWholeCells)
{
    const auto exact = VoxelGrid<2>::make({-1.0, 2.0}, {1.0, 2.6}, 0.2).grid;
    EXPECT_EQ(exact.counts(), Eigen::Vector2i(10, 3));  // 0.6 / 0.2 is not 3 in doubles
    const auto wider = VoxelGrid<3>::make({0, 0, 0}, {1.0, 1.05, 0.01}, 0.5).grid;
    EXPECT_EQ(wider.counts(), Eigen::Vector3i(2, 3, 1));
    EXPECT_EQ(wider.upper(), Vector3d(1.0, 1.5, 0.5));
    EXPECT_EQ(wider.freeCells(), 6);
}

TEST(VoxelGrid, MapsCellsToPointsAndBack)
{
    const auto grid = VoxelGrid<3>::make({-1.0, 0.5, 3.0}, {1.1, 2.0, 3.9}, 0.3).grid;
    EXPECT_EQ(grid.stride(0), 1);
    EXPECT_EQ(grid.stride(1), 7);
    EXPECT_EQ(grid.stride(2), 35);
    for (int cell = 0; cell < grid.cells(); ++cell)
    {
        EXPECT_EQ(grid.cell(grid.index(cell)), cell);
        EXPECT_EQ(grid.cellAround(grid.center(cell)), cell);
    }
    EXPECT_TRUE(grid.center(0).isApprox(Vector3d(-0.85, 0.65, 3.15)));
    EXPECT_EQ(grid.cellAround({-1.001, 0.6, 3.1}), -1);
    EXPECT_EQ(grid.cellAround({1.101, 0.6, 3.1}), -1);
    EXPECT_EQ(grid.cellAround({std::nan(""), 0.6, 3.1}), -1);
}

TEST(VoxelGrid, SaysWhyThereIsNone)
{
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(VoxelGrid<2>::make({0, 0}, {1, infinity}, 0.1).failure, GridFailure::NotFinite);
    EXPECT_EQ(VoxelGrid<2>::make({0, 0}, {1, 1}, std::nan("")).failure, GridFailure::NotFinite);
    EXPECT_EQ(VoxelGrid<2>::make({0, 0}, {1, 0}, 0.1).failure, GridFailure::EmptyBounds);
    EXPECT_EQ(VoxelGrid<2>::make({0, 0}, {1, 1}, 0.0).failure, GridFailure::BadSpacing);
    EXPECT_EQ(VoxelGrid<3>::make({0, 0, 0}, {1, 1, 1}, 1e-7).failure, GridFailure::TooManyCells);
    EXPECT_EQ(VoxelGrid<3>::make({0, 0, 0}, {1, 1, 1}, 0.1, 999).failure, GridFailure::TooManyCells);
    EXPECT_EQ(VoxelGrid<3>::make({0, 0, 0}, {1, 1, 1}, 0.1, 1000).failure, GridFailure::None);
    EXPECT_EQ(toText(GridFailure::TooManyCells), "too_many_cells");
}

TEST(VoxelGrid, OccupiesTheCellsWithinRoomOfPlanarObstacles)
{
    const Polygon notch{{{0.5, 0.5}, {2.5, 0.5}, {2.5, 2.5}, {1.5, 1.0}, {0.5, 2.5}}};
    const Superellipse oval{{3.5, 3.0}, {0.7, 0.3}, 4.0};
    const SuperellipseGeometry ovalGeometry(oval);
    for (double room : {0.0, 0.31})
    {
        auto grid = VoxelGrid<2>::make({0, 0}, {5, 4}, 0.0625).grid;
        occupyCells(grid, {{"n", notch}, {"o", oval}, {"c", Circle{{4.0, 1.0}, 0.5}}}, room);
        int occupied = 0;
        for (int cell = 0; cell < grid.cells(); ++cell)
        {
            const Vector2d p = grid.center(cell);
            const bool near = distance(p, p, notch) <= room || ovalGeometry.distance(p, p) <= room ||
                              (p - Vector2d(4.0, 1.0)).norm() - 0.5 <= room;
            EXPECT_EQ(grid.occupied(cell), near) << p.transpose() << " room " << room;
            occupied += near ? 1 : 0;
        }
        EXPECT_EQ(grid.freeCells(), grid.cells() - occupied);
    }
}

/// A cube from -1 to 1, its triangles seen counter-clockwise from outside.
Mesh cube()
{
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.emplace_back((i & 1) ? 1.0 : -1.0, (i & 2) ? 1.0 : -1.0, (i & 4) ? 1.0 : -1.0);
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    mesh.closed = true;
    return mesh;
}

TEST(VoxelGrid, OccupiesAMeshAsTheBoxOfItsShape)
{
    const Box box{Eigen::Isometry3d::Identity(), {1.0, 1.0, 1.0}};
    auto byMesh = VoxelGrid<3>::make({-2, -2, -2}, {2, 2, 2}, 0.15).grid;
    auto byBox = byMesh;
    occupyCells(byMesh, {{"m", cube()}}, 0.2);
    occupyCells(byBox, {{"b", box}}, 0.2);
    for (int cell = 0; cell < byMesh.cells(); ++cell)
    {
        const Vector3d p = byMesh.center(cell);
        EXPECT_EQ(byMesh.occupied(cell), byBox.occupied(cell)) << p.transpose();
        EXPECT_EQ(byBox.occupied(cell), nearness(p, p, box).distance <= 0.2) << p.transpose();
    }
    EXPECT_TRUE(byMesh.occupied(byMesh.cellAround({0, 0, 0})));
}

TEST(VoxelGrid, LetsNothingThinSlipBetweenCentersWithHalfADiagonalOfRoom)
{
    const double h = 0.1;
    const Capsule wire{{0.03, 0.02, 0.01}, {0.97, 0.88, 0.71}, 1e-6};
    auto grid = VoxelGrid<3>::make({0, 0, 0}, {1, 1, 1}, h).grid;
    auto bare = grid;
    occupyCells(bare, {{"w", wire}}, 0.0);
    EXPECT_EQ(bare.freeCells(), 1000);  // no center is on it
    occupyCells(grid, {{"w", wire}}, 0.5 * h * std::sqrt(3.0));
    for (int i = 0; i <= 1000; ++i)
        EXPECT_TRUE(grid.occupied(grid.cellAround(wire.from + i / 1000.0 * (wire.to - wire.from))));
}
}  // namespace
}  // namespace narrows
