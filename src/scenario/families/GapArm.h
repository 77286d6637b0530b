// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// An arm of two carriers and some rods in a row, each cut into links, and the configurations in which the rods lie on
/// one line: where the carriers can slide them along it. Angles are absolute, the base is the origin.
class GapArm
{
public:
    static constexpr int carriers = 2;

    /// \param rods lengths of the carriers and the rods; what links round off them is lost
    /// \param links >= the number of rods and carriers
    GapArm(const std::vector<double> &rods, int links);

    /// How many links carrier or rod i is cut into.
    static int share(int i, int rods, int links) { return (links + i) / rods; }

    const std::vector<double> &lengths() const { return lengths_; }  ///< of the links
    /// Length of carrier or rod i, as its links have it.
    double rod(int i) const { return rods_[static_cast<std::size_t>(i)]; }
    int rodCount() const { return static_cast<int>(rods_.size()); }
    int carrierLinks() const { return carrierLinks_; }

    /// Decides where the rods' line is: along `direction`, beginning at `begin` in a frame along it, if the goal's
    /// angles were not rounded to 6 decimals. \param side 1 or -1: to which side the carriers bend \return false if the
    /// carriers do not reach that far
    bool place(double direction, const Eigen::Vector2d &begin, int side);

    /// The placed configuration, drawn back along the line by some way; not finite where the carriers do not reach.
    Eigen::VectorXd drawnBack(double way) const;
    Eigen::VectorXd placed() const { return configuration(angles_); }
    Eigen::Vector2d along() const;
    /// Where the rods begin.
    const Eigen::Vector2d &begin() const { return begin_; }

private:
    Eigen::VectorXd configuration(const Eigen::Vector2d &carrierAngles) const;

    std::vector<double> lengths_;
    std::vector<double> rods_;
    int carrierLinks_ = 0;
    double direction_ = 0.0;
    int side_ = 1;
    Eigen::Vector2d angles_;  ///< of the carriers as placed
    Eigen::Vector2d begin_;
};
}  // namespace narrows
