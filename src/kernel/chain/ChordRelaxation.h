// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kernel/chain/ChainCertificate.h"

namespace narrows
{
/// How paths are bent until chains can follow them.
struct RelaxationOptions
{
    double spacing;  ///< > 0, of the path's nodes; a tenth to a twentieth of a corridor's width
    double margin;   ///< > 0, more than the radius that links are pushed away from obstacles; below the spacing
    double maxMove;  ///< > 0, of a node in one round
    double smoothing =
        0.15;               ///< in [0, 1], share of the way to the middle of its neighbours that a node takes per round
    int rounds = 400;       ///< >= 1
    double goalRoom = 0.0;  ///< >= 0, how far from the goal the path may end
    CertificateOptions certificate = {};  ///< how closely the certificate looks
};

/// Options in proportion to the scene.
/// \param width of the narrowest corridor, or what comes near it, > 0
RelaxationOptions relaxationOptions(double width);

/// A path that a chain can follow, or the best that was found.
template <int D>
struct RelaxedPath
{
    PointPath<D> nodes;            ///< from the same start to the same goal
    ChainCertificate certificate;  ///< of `nodes`
    int rounds = 0;                ///< of pushing
    int certificates = 0;          ///< how often it was asked for
    long chords = 0;               ///< pushed or looked at
};

/// Bends a path until a chain can follow it (section 4(ii) of the findings: the paper's beams tie its path to lines,
/// and it is not complete).
///
/// Every round looks at the chords P(g(s))P(s) all along the path: those that come closer to an obstacle than radius
/// and margin push the nodes at both of their ends, and so do joints bent too far and, once the certificate has found
/// links that meet, links too near each other. Where g is about to jump the path is straightened. Each node goes the
/// weighted mean of what is asked of it and a little towards its neighbours. It is a local search: what comes of it
/// depends on where it begins. A path much longer than the chain is given up.
/// \param nodes from the entrance, which stays where it is, to the goal
/// \param stop asked once per round; may be empty
/// \return the first path that certifyChain() accepts; else the last one, and why not
/// \throws std::invalid_argument if the options are out of range
template <int D>
RelaxedPath<D> relaxChords(const PointPath<D> &nodes, const Eigen::Matrix<double, D, 1> &entrance,
                           const ChordObstacles<D> &obstacles, const ChainSpec &spec, const RelaxationOptions &options,
                           const std::function<bool()> &stop = {});

extern template RelaxedPath<2> relaxChords(const PointPath<2> &, const Eigen::Vector2d &, const ChordObstacles<2> &,
                                           const ChainSpec &, const RelaxationOptions &, const std::function<bool()> &);
extern template RelaxedPath<3> relaxChords(const PointPath<3> &, const Eigen::Vector3d &, const ChordObstacles<3> &,
                                           const ChainSpec &, const RelaxationOptions &, const std::function<bool()> &);
}  // namespace narrows
