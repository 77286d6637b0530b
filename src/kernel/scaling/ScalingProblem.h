// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kernel/JointCentres.h"
#include "kernel/scaling/ConvexSection.h"

namespace narrows
{
/// Projections of a chain's joint centres, P_1 .. P_{n+1}, into the section plane (paper: Y0 Z0).
using SectionChain = std::vector<Eigen::Vector2d>;

/// A long round bar across the slide, which no arm can pass on its ends ("obs3" of the paper).
struct Crossbar
{
    double x;                ///< along the slide
    double offset;           ///< coordinate of its axis along `across`
    Eigen::Vector2d across;  ///< unit vector of the section plane at right angles to its axis
    double radius;           ///< > 0
};

/// A chain of universal joints on a slide among obstacles, as the variable-dimension scaling method sees them: in the
/// SLIDE FRAME, where x runs along the slide in the direction that the chain points to, the section plane is (y, z),
/// and O_1 is at (x_0, 0, 0). The zoom centre is the origin: where the base is.
struct ScalingProblem
{
    std::vector<double> lengths;                         ///< L_1 .. L_n, > 0
    double radius = 0.0;                                 ///< of the links, >= 0
    double maxAngle = 0.0;                               ///< largest link angle psi, >= 0; infinity without a limit
    Interval slide = ConvexSection::everywhere();        ///< permitted x_0
    Eigen::Vector3d forward = Eigen::Vector3d::UnitX();  ///< where link 1 points when psi_1 = 0; unit
    std::vector<ConvexSection> sections;                 ///< of obstacles along the slide
    std::vector<Crossbar> crossbars;                     ///< obstacles across it

    std::size_t links() const { return lengths.size(); }  ///< of the chain, without the slide
    double reach() const;                                 ///< the sum of the links' lengths
    /// k_{i,n+1} = (L_1 + .. + L_{i-1}) / (L_1 + .. + L_n) for i = 1 .. n+1 (Eq. 5).
    std::vector<double> fractions() const;
};

/// The slide frame of a chain: columns are x, y, z.
Eigen::Matrix3d slideAxes(const ChainGeometry &chain);

/// The chain alone, in its slide frame; obstacles are to be added.
ScalingProblem scalingProblem(const ChainGeometry &chain);

/// Why a tip has no pose.
enum class ScalingFailure
{
    None,
    Reach,          ///< the tip is farther from the slide than the arm can get
    Slide,          ///< x_0 is beyond its limits
    BaseBlocked,    ///< the slide itself runs through a danger region
    TipBlocked,     ///< the tip is to be inside a danger region
    NoCandidate,    ///< all points on the auxiliary lines are inside other danger regions
    Span,           ///< a link is too short for the distance between its joints' projections
    LinkAngle,      ///< psi is beyond its limit
    LinkClearance,  ///< a link comes too close to an obstacle
    Jump,           ///< a joint would have to jump
    Overlap         ///< the tip is to go where danger regions enclose it together
};

/// "reach", "link_angle", ...; empty for None.
std::string toText(ScalingFailure failure);

/// Why and where scaling failed.
struct ScalingFault
{
    ScalingFailure failure = ScalingFailure::None;  ///< none: nothing failed
    int link = -1;     ///< index of the link or, for NoCandidate and Jump, of the joint centre; -1: about none
    int section = -1;  ///< index of the obstacle's section; -1: about none

    /// Whether something failed.
    explicit operator bool() const { return failure != ScalingFailure::None; }
};
}  // namespace narrows
