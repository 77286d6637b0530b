// SPDX-License-Identifier: BSD-3-Clause
// Can links of a length be excluded from one of the planar corridors of tight maneuvering, whatever path they take?
// Usage: 07_excluded_lengths SHAPE LENGTH [LINKS [EDGE [DEGREES]]]   (see docs/tight.md)
//   LINKS 1 or 2 (standard: 2), EDGE of the cells (2), DEGREES of the finest intervals of directions (0.5)
#include <iostream>
#include <stdexcept>

#include <fmt/format.h>

#include "kernel/chain/LadderSearch.h"
#include "scenario/families/Family.h"

namespace
{
using namespace narrows;

int run(int argc, char **argv)
{
    if (argc < 3 || argc > 6)
        throw std::invalid_argument("usage: 07_excluded_lengths SHAPE LENGTH [LINKS [EDGE [DEGREES]]]");
    const Family &family = findFamily("ladder");
    const auto scene = std::get<ChainScene<2>>(family.draw(family.values({{"shape", argv[1]}, {"length", argv[2]}})));
    const AxisBox<2> bounds = boundsOf(scene.walls);
    LadderSearchOptions options;
    options.links = argc > 3 ? std::stoi(argv[3]) : 2;
    options.spacing = argc > 4 ? std::stod(argv[4]) : 2.0;
    options.finestAngle = (argc > 5 ? std::stod(argv[5]) : 0.5) * M_PI / 180.0;
    const LadderSearch search = excludeLadder({scene.entrance, Eigen::Vector2d::UnitY(), scene.goal, scene.tolerance,
                                               scene.length, scene.radius, bounds.lower, bounds.upper},
                                              signedDistance<2>(scene.walls), options);
    std::cout << fmt::format("{} {:g}, {} link{}, cells of {:g}: {} ({} cells, {} nodes, {} links looked at)\n",
                             argv[1], scene.length, options.links, options.links == 1 ? "" : "s", options.spacing,
                             toText(search.verdict), search.cells, search.nodes, search.rays);
    return search.verdict == LadderVerdict::Excluded ? 0 : 1;
}
}  // namespace

int main(int argc, char **argv)
{
    try
    {
        return run(argc, argv);
    }
    catch (const std::exception &error)
    {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
