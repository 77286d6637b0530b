// SPDX-License-Identifier: BSD-3-Clause
// maze: a chain on a slide is fed into a maze of unit cells. The maze is carved by a random walk that steps back from
// dead ends (perfect: one way between any two cells); `braid` opens dead ends. The way is the shortest one. The witness
// moves the base and lets every joint follow the way's middle line, each at the first place that is a link's length
// ahead of the one before.
#include <cmath>

#include "scenario/families/Draws.h"
#include "scenario/families/Families.h"
#include "scenario/families/MazeGrid.h"
#include "scenario/families/RandomNumbers.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::VectorXd;

void addWall(ArmScene &scene, double left, double bottom, double right, double top)
{
    addObstacle(scene, Polygon{{rounded(Vector2d(left, bottom), 12), rounded(Vector2d(right, bottom), 12),
                                rounded(Vector2d(right, top), 12), rounded(Vector2d(left, top), 12)}});
}

/// Walls between cells that no door joins and around the maze, but at its entrance, the left side of the first cell.
/// The entrance's middle is the origin.
void addWalls(ArmScene &scene, const MazeGrid &grid, double thickness)
{
    const double half = thickness / 2.0;
    for (int y = 0; y < grid.rows(); ++y)
        for (int x = 0; x <= grid.columns(); ++x)
        {
            const bool entrance = x == 0 && y == 0;
            if (!entrance && (x == 0 || x == grid.columns() || !grid.isOpen({x, y}, MazeGrid::Left)))
                addWall(scene, x - half, y - 0.5 - half, x + half, y + 0.5 + half);
        }
    for (int y = 0; y <= grid.rows(); ++y)
        for (int x = 0; x < grid.columns(); ++x)
            if (y == 0 || y == grid.rows() || !grid.isOpen({x, y}, MazeGrid::Down))
                addWall(scene, x - half, y - 0.5 - half, x + 1.0 + half, y - 0.5 + half);
}

/// The way's middle line, from the entrance on, and beyond it to the left without end.
class MiddleLine
{
public:
    explicit MiddleLine(const std::vector<MazeGrid::Cell> &cells)
    {
        points_.push_back(Vector2d::Zero());
        for (const auto &[x, y] : cells)
            points_.push_back(Vector2d(x + 0.5, y));
    }

    double length() const { return static_cast<double>(points_.size()) - 1.5; }

    /// A chain along the line with its base at (slide, 0), slide <= 0: [slide, absolute angles].
    VectorXd follow(double slide, const std::vector<double> &links) const
    {
        VectorXd q(static_cast<Eigen::Index>(links.size()) + 1);
        q[0] = slide;
        Vector2d base(slide, 0.0);
        std::size_t piece = 0;  // the base is on the one that ends at points_[piece]
        for (std::size_t i = 0; i < links.size(); ++i)
        {
            while ((points_[piece] - base).norm() < links[i] && piece + 1 < points_.size())
                ++piece;
            const Vector2d tip = crossing(base, links[i], piece);
            q[static_cast<Eigen::Index>(i) + 1] = std::atan2(tip.y() - base.y(), tip.x() - base.x());
            base = tip;
        }
        return q;
    }

private:
    /// Where the line's piece first is that far from a point that all pieces before it are nearer to.
    Vector2d crossing(const Vector2d &from, double distance, std::size_t piece) const
    {
        const Vector2d end = points_[piece];
        const Vector2d back =
            piece == 0 ? Vector2d(-Vector2d::UnitX()) : Vector2d((points_[piece - 1] - end).normalized());
        const double along = (from - end).dot(back);
        const double across = (from - end - along * back).squaredNorm();
        return end + (along - std::sqrt(distance * distance - across)) * back;
    }

    std::vector<Vector2d> points_;
};

/// Angles by the turns that follow the first of them without a jump.
void unwind(VectorXd &q, const VectorXd &before)
{
    for (Eigen::Index i = 1; i < q.size(); ++i)
        q[i] = before[i] + std::remainder(q[i] - before[i], 2.0 * M_PI);
}

ArmScene drawOnce(const FamilyValues &values, RandomNumbers &random)
{
    MazeGrid grid(static_cast<int>(values.at("columns")), static_cast<int>(values.at("rows")));
    grid.carve(random);
    grid.braid(values.at("braid"), random);
    const MiddleLine line(grid.way());
    const double thickness = values.at("thickness");
    const int links = static_cast<int>(values.at("links"));
    // Chords at bends are shorter than the line that they stand for; the rest is left at its end.
    const double length = rounded(std::min(0.6 * (1.0 - thickness), 0.8 * line.length() / links), 6);

    ArmScene scene;
    scene.radius = values.at("radius");
    scene.lengths.assign(static_cast<std::size_t>(links), length);
    const double reach = rounded(links * length + thickness, 6);
    scene.slide = Slide{Vector2d::UnitX(), -reach - 0.5, 0.0};
    addWalls(scene, grid, thickness);
    scene.start = VectorXd::Zero(links + 1);
    scene.start[0] = -reach;
    scene.witness = {scene.start};
    const int waypoints = static_cast<int>(std::ceil(reach / (0.2 * length)));
    for (int i = 1; i <= waypoints; ++i)
    {
        VectorXd q = line.follow(-reach * (waypoints - i) / waypoints, scene.lengths);
        unwind(q, scene.witness.back());
        scene.witness.push_back(q);
    }
    for (double &value : scene.witness.back())
        value = rounded(value, 9);
    scene.goal = scene.witness.back();
    return scene;
}

ArmScene drawMaze(const FamilyValues &values)
{
    constexpr int mostDraws = 200;
    RandomNumbers random(static_cast<std::uint64_t>(values.at("seed")));
    ArmScene scene;
    drawUntilOneWillDo(mostDraws,
                       [&]()
                       {
                           scene = drawOnce(values, random);
                           return judgeMotion(scene, scene.start, scene.goal) == Motion::Blocked &&
                                  judgePath(scene, scene.witness) == Motion::Free;
                       });
    return scene;
}
}  // namespace

Family gridMazeFamily()
{
    using Kind = FamilyParameter::Kind;
    return {"maze",
            "a chain on a slide is fed into a maze of unit cells, along the way to its far corner",
            {{"links", Kind::Whole, 20, 1, 200, "of the chain, equally long: as long as the way takes and bends let"},
             {"columns", Kind::Whole, 5, 2, 50, "of cells"},
             {"rows", Kind::Whole, 5, 2, 50, "of cells"},
             {"thickness", Kind::Real, 0.2, 0.01, 0.8, "of the walls"},
             {"radius", Kind::Real, 0.01, 0.0, 0.2, "of the links"},
             {"braid", Kind::Real, 0.0, 0.0, 1.0, "share of the dead ends that get a second door"},
             {"seed", Kind::Whole, 1, 0, 1e9, "of the random numbers"}},
            drawMaze};
}
}  // namespace narrows
