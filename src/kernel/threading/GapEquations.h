// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// How far off the middle links cross a gap, beside its half width, in its sizes.
constexpr double throatPart = 0.3;
/// |sine| of the least angle between a link that crosses and the gap's axis; in space the gap's plane too.
constexpr double leastSquareness = 0.5;

/// A link that crosses a gap.
struct GapCrossing
{
    int link;     ///< index of the link that crosses
    int gap;      ///< index of the gap, below gapCount()
    bool square;  ///< the link shall also stand square to the gap's axis
};

/// The equations F = 0 of the configurations in which links of an arm go through gaps in the middle: one row F1, a
/// length, per crossing and, if it is square, another one F2, a sine. Smooth wherever links cross gaps, in collision
/// too. What CentredStep needs to know of a robot. Immutable and thread-safe.
class GapEquations
{
public:
    using Configuration = Eigen::Ref<const Eigen::VectorXd>;  ///< of the arm: joints as it counts them

    virtual ~GapEquations() = default;

    virtual int gapCount() const = 0;  ///< how many gaps there are
    /// Half the room that the link has across the gap, which may move with the arm.
    virtual double halfWidth(const Configuration &q, const GapCrossing &crossing) const = 0;
    /// How far off its middle, along the link, what makes the gap narrow still does; > 0.
    virtual double size(const GapCrossing &crossing) const = 0;

    /// Which links cross which gaps, on links taken for longer at both ends. All are square.
    /// \param lengthening in sizes of the gap; >= 0
    virtual void crossings(const Configuration &q, double lengthening, std::vector<GapCrossing> &result) const = 0;

    /// F by rows, and its derivative by the configuration, one column per row.
    virtual void evaluate(const Configuration &q, const std::vector<GapCrossing> &crossings, Eigen::VectorXd &values,
                          Eigen::MatrixXd &transposedJacobian) const = 0;

protected:
    /// How many rows F has.
    static Eigen::Index rowCount(const std::vector<GapCrossing> &crossings)
    {
        Eigen::Index rows = 0;
        for (const GapCrossing &crossing : crossings)
            rows += crossing.square ? 2 : 1;
        return rows;
    }
};
}  // namespace narrows
