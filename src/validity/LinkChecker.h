// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "kernel/LinkMotion.h"
#include "kernel/BoxArrays.h"

namespace narrows
{
/// What is known of a link on a stretch of motion.
enum class Finding
{
    Clear,    ///< touches nothing, all along the stretch
    Unsure,   ///< touches nothing in the middle; the rest could not be told
    Touching  ///< touches something in the middle
};

/// Answers, for one link at a time, whether it keeps away from all obstacles, and for two, whether they keep away from
/// each other. Everything that says "free" in this project (states and motions, for every planner) goes through this
/// interface. Touching counts as a collision. Immutable, so that threads may share one.
template <int Dim>
class LinkChecker
{
public:
    virtual ~LinkChecker() = default;

    /// The obstacles that may touch something in each of the boxes: all those whose own boxes they meet, here any.
    virtual void findNear(const BoxArrays<Dim> &boxes, std::vector<ObstacleBits> &near) const
    {
        near.assign(boxes.count(), allObstacles);
    }

    /// Whether no obstacle touches the link.
    /// \param link at rest \param near obstacles that are not among them are known to be far away
    virtual bool clears(const Link<Dim> &link, ObstacleBits near) const = 0;
    /// The same, of all obstacles.
    bool clears(const Link<Dim> &link) const { return clears(link, allObstacles); }

    /// Distance from the link to the nearest obstacle: negative or zero iff they touch (then its size means nothing),
    /// +infinity without obstacles.
    virtual double clearance(const Link<Dim> &link) const = 0;

    /// The worst of what can be told of the link and any obstacle.
    /// \param link on a stretch of motion \param near as above, of the box around all that the
    /// link can reach
    virtual Finding examine(const LinkMotion<Dim> &link, ObstacleBits near) const = 0;
    /// The same, of all obstacles.
    Finding examine(const LinkMotion<Dim> &link) const { return examine(link, allObstacles); }

    ///@{
    /// The same of two links of one arm, each other's only obstacle.
    virtual bool clears(const Link<Dim> &link, const Link<Dim> &other) const = 0;
    virtual double clearance(const Link<Dim> &link, const Link<Dim> &other) const = 0;
    virtual Finding examine(const LinkMotion<Dim> &link, const LinkMotion<Dim> &other) const = 0;
    ///@}
};

/// Makes a checker for a model, planar or spatial, by its name: "analytic" or "fcl" (see PlanarChecker.h and
/// SpatialChecker.h, one of which must be included).
/// \throws std::invalid_argument for any other name.
template <class Model>
auto makeChecker(const std::string &name, const Model &model)
{
    if (name == "analytic")
        return makeAnalyticChecker(model);
    if (name == "fcl")
        return makeFclChecker(model);
    throw std::invalid_argument("checker \"" + name + "\" is unknown; there are analytic and fcl");
}
}  // namespace narrows
