// SPDX-License-Identifier: BSD-3-Clause
// cut: HPPM-PRA, Section 5.3, Table 3, with the errata of experiments/scenarios/hppm_case3.yaml, and every link cut
// into equal pieces. Whatever the uncut arm can do the cut one can, so that one witness serves all.
#include <array>
#include <cmath>

#include "scenario/families/Families.h"

namespace narrows
{
namespace
{
constexpr int links = 20;
using Angles = std::array<double, links>;

constexpr double quarter = M_PI / 2.0;
constexpr double eighth = M_PI / 4.0;

/// Waypoints between start and goal: HPPM's curve with the recipe of that file, shortened as far as 0.005
/// of clearance remains, and rounded.
constexpr Angles between[] = {
    {3.348,  2.777, 1.940,  2.678, 1.535, 1.945, 2.318, 2.107, 1.956, 1.042,
     -0.379, 1.807, -0.583, 0.504, 2.985, 3.772, 2.242, 2.269, 1.974, 1.821},
    {3.160,  2.579, 1.729,  2.479,  1.316, 1.734, 1.908, 1.490, 1.335, 0.406,
     -1.242, 0.980, -1.450, -0.140, 2.586, 3.386, 1.831, 1.859, 1.149, 0.585},
    {2.079,  1.805,  1.403,  1.757,  1.208, 1.405, 0.831, -0.024, -0.097, -0.536,
     -1.972, -0.922, -2.070, -0.794, 1.151, 1.529, 0.794, 0.807,  -0.842, -2.422},
    {1.890,  1.688,  1.392,  1.653,  1.248, 1.393, 0.708, -0.184, -0.237, -0.561,
     -1.881, -1.107, -1.954, -0.752, 0.945, 1.223, 0.681, 0.691,  -1.048, -2.736},
    {1.697,  1.654,  1.591,  1.646, 1.560, 1.591, 0.885, 0.134, 0.123,  0.054,
     -0.787, -0.622, -0.803, 0.014, 0.935, 0.994, 0.879, 0.881, -0.610, -2.090},
    {1.631,  1.620,  1.604,  1.618, 1.596, 1.604, 0.867, 0.118, 0.115,  0.097,
     -0.675, -0.632, -0.679, 0.086, 0.880, 0.895, 0.865, 0.866, -0.629, -2.121},
    {1.578,  1.590,  1.608,  1.592, 1.616, 1.607, 0.842, 0.089, 0.092,  0.112,
     -0.616, -0.662, -0.611, 0.123, 0.828, 0.811, 0.844, 0.843, -0.665, -2.177},
    {1.552,  1.574,  1.605,  1.577, 1.621, 1.605, 0.825, 0.066, 0.072,  0.106,
     -0.606, -0.689, -0.598, 0.127, 0.799, 0.769, 0.827, 0.826, -0.696, -2.223},
    {1.548,  1.569,  1.598,  1.572, 1.612, 1.598, 0.812, 0.047, 0.052,  0.084,
     -0.638, -0.715, -0.631, 0.103, 0.789, 0.761, 0.815, 0.814, -0.721, -2.261},
};

constexpr Angles goal = {quarter, quarter, quarter, quarter, quarter, quarter, eighth, 0.0,    0.0,     0.0,
                         -eighth, -eighth, -eighth, 0.0,     eighth,  eighth,  eighth, eighth, -eighth, -3.0 * eighth};

/// Every angle `pieces` times.
Eigen::VectorXd repeated(const Angles &angles, int pieces)
{
    Eigen::VectorXd q(links * pieces);
    for (Eigen::Index i = 0; i < q.size(); ++i)
        q[i] = angles[static_cast<std::size_t>(i / pieces)];
    return q;
}

ArmScene drawCutCase(const FamilyValues &values)
{
    const int pieces = static_cast<int>(values.at("pieces"));
    // Half extents (Eq. 22): fourth roots of the printed coefficients.
    const Eigen::Vector2d flat(std::pow(300.0, 0.25), std::pow(0.01, 0.25));
    const Eigen::Vector2d upright(std::pow(0.02, 0.25), std::pow(15.0, 0.25));
    const Eigen::Vector2d low(std::pow(0.02, 0.25), std::pow(8.0, 0.25));
    ArmScene scene;
    scene.lengths.assign(static_cast<std::size_t>(links * pieces), std::sqrt(0.5) / pieces);
    addObstacle(scene, Circle{{6.84, 4.75}, 0.15});
    addObstacle(scene, Circle{{-3.0, 8.0}, 0.5});
    const std::pair<Eigen::Vector2d, Eigen::Vector2d> walls[] = {
        {{4.5, 7.5}, flat}, {{4.5, 5.9}, upright}, {{8.5, 2.1}, upright}, {{4.5, 0.5}, flat}, {{0.5, 1.7}, low}};
    for (const auto &[center, extents] : walls)
        addObstacle(scene, Superellipse{center, rounded(extents, 12), 4.0});
    scene.start = Eigen::VectorXd::Constant(links * pieces, 3.0 * eighth);
    scene.goal = repeated(goal, pieces);
    scene.witness = {scene.start};
    for (const Angles &angles : between)
        scene.witness.push_back(repeated(angles, pieces));
    scene.witness.push_back(scene.goal);
    return scene;
}
}  // namespace

Family cutFamily()
{
    return {"cut",
            "case 3 of HPPM-PRA, twenty links through a passage of flat walls, every link cut into pieces",
            {{"pieces", FamilyParameter::Kind::Whole, 1, 1, 16, "that each of the twenty links is cut into"}},
            drawCutCase};
}
}  // namespace narrows
