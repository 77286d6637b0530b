// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>

#include "kernel/chain/ChordObstacles.h"
#include "kernel/chain/LeaderPath.h"

namespace narrows
{
/// A chain of equal links that follows its tip from an entrance line.
struct ChainSpec
{
    int links;                                                  ///< >= 1
    double length;                                              ///< of a link, > 0
    double radius;                                              ///< of a link, >= 0
    double maxAngle = std::numeric_limits<double>::infinity();  ///< largest bend of a joint, > 0, radians
    bool selfCollision = false;                                 ///< links that are not neighbours must not touch
};

/// Why a chain cannot follow a path.
enum class ChainFailure
{
    None,
    TooShort,        ///< the links do not reach back to the entrance line when the tip is at the end
    Jump,            ///< a joint would have to jump: g is not continuous
    ChordClearance,  ///< a link comes closer to an obstacle than its radius
    JointLimit,      ///< a joint bends too far
    SelfCollision,   ///< the way of one link meets the way of a later one that is not its neighbour
    Unresolved,      ///< not decided after as many chords as asked for
};

/// "chord_clearance" and the like.
std::string toText(ChainFailure failure);

/// How closely a path is looked at.
struct CertificateOptions
{
    double resolution = 1e-7;  ///< > 0, in link lengths: what is not decided over so short a stretch is a failure
    int maxChords = 200'000;   ///< >= 1, how many chords are looked at
};

/// What is known of a chain that follows a path.
struct ChainCertificate
{
    ChainFailure failure = ChainFailure::None;  ///< none: proven
    double place = 0.0;                         ///< s of the front end of the link that fails, or of the joint
    double clearance = 0.0;                     ///< least distance of any chord that was looked at from obstacles
    double largestAngle = 0.0;                  ///< bend of any joint that was looked at
    double amplification = 0.0;  ///< greatest speed of a joint over that of the tip: a reading, not a bound
    int chords = 0;              ///< how many were looked at

    /// Whether the chain can follow the path.
    explicit operator bool() const { return failure == ChainFailure::None; }
};

/// Decides whether a chain of any number of equal links can follow a path: it can iff every chord from P(g(s)) to P(s)
/// keeps the radius from all obstacles and g is continuous, because every link at any time is such a chord.
///
/// Nothing is sampled: the path is halved until what is known of the chord in the middle of a stretch covers the
/// stretch. While the front end moves by no more than d, g stays between the last places that are L + d and L - d away,
/// and is continuous if the distance falls strictly in between. Self-collision is decided for the ways of links rather
/// than for links at a time: chords at s and at any s' <= g(g(s)) keep two radii apart. That is more than is needed.
/// \throws std::invalid_argument if the spec or the options are out of range
template <int D>
ChainCertificate certifyChain(const LeaderPath<D> &path, const ChordObstacles<D> &obstacles, const ChainSpec &spec,
                              const CertificateOptions &options = {});

extern template ChainCertificate certifyChain(const LeaderPath<2> &, const ChordObstacles<2> &, const ChainSpec &,
                                              const CertificateOptions &);
extern template ChainCertificate certifyChain(const LeaderPath<3> &, const ChordObstacles<3> &, const ChainSpec &,
                                              const CertificateOptions &);
}  // namespace narrows
