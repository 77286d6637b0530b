// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PlanarArm.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "kernel/SineCosine.h"

namespace narrows
{
namespace
{
void checkLinks(const std::vector<PlanarLink> &links)
{
    if (links.empty())
        throw std::invalid_argument("an arm needs at least one link");
    for (std::size_t i = 0; i < links.size(); ++i)
    {
        if (!(links[i].length > 0.0) || !std::isfinite(links[i].length))
            throw std::invalid_argument("link " + std::to_string(i) + ": length must be positive and finite");
        if (links[i].parent < -1 || links[i].parent >= static_cast<int>(i))
            throw std::invalid_argument("link " + std::to_string(i) + ": the parent must come before the link");
    }
}

void checkSlide(const Slide &slide)
{
    if (!(std::abs(slide.axis.norm() - 1.0) < 1e-9))
        throw std::invalid_argument("the slide's axis must be a unit vector");
    if (!(slide.lower <= slide.upper))
        throw std::invalid_argument("the slide's limits must be ordered");
}

/// Where the links end; tips[-1] is the base.
void placeOneByOne(const std::vector<PlanarLink> &links, const double *angles, Eigen::Vector2d *tips)
{
    for (std::size_t i = 0; i < links.size(); ++i)
    {
        // Both before anything is stored, so that the compiler makes one sincos of them.
        const double cosine = std::cos(angles[i]);
        const double sine = std::sin(angles[i]);
        const Eigen::Vector2d &from = tips[links[i].parent];
        tips[i] = {from.x() + links[i].length * cosine, from.y() + links[i].length * sine};
    }
}

/// The same, faster for many links.
void placeInBlocks(const std::vector<PlanarLink> &links, const double *angles, Eigen::Vector2d *tips)
{
    const int linkCount = static_cast<int>(links.size());
    SineCosineBlock turns;
    double x = tips[-1].x(), y = tips[-1].y();
    for (int first = 0; first < linkCount; first += turns.most)
    {
        const int count = std::min(turns.most, linkCount - first);
        std::copy_n(angles + first, count, turns.angles);
        turns.evaluate(count);
        const PlanarLink *link = links.data() + first;
        for (int i = first, k = 0; k < count; ++i, ++k, ++link)
        {
            if (link->parent != i - 1)  // else it is the link before, whose tip need not be fetched from memory
            {
                x = tips[link->parent].x();
                y = tips[link->parent].y();
            }
            x += link->length * turns.cosines[k];
            y += link->length * turns.sines[k];
            tips[i] = {x, y};
        }
    }
}
}  // namespace

PlanarArm::PlanarArm(const Eigen::Vector2d &base, std::vector<PlanarLink> links, double radius,
                     std::optional<Slide> slide)
  : base_(base), links_(std::move(links)), radius_(radius), slide_(std::move(slide))
{
    checkLinks(links_);
    if (!(radius_ >= 0.0) || !std::isfinite(radius_))
        throw std::invalid_argument("the link radius must not be negative");
    if (slide_)
        checkSlide(*slide_);
}

double PlanarArm::reach() const
{
    std::vector<double> length(links_.size());
    for (std::size_t i = 0; i < links_.size(); ++i)
        length[i] = links_[i].length + (links_[i].parent < 0 ? 0.0 : length[links_[i].parent]);
    return *std::max_element(length.begin(), length.end());
}

void PlanarArm::place(ConfigurationRef q, std::vector<Eigen::Vector2d> &points) const
{
    points.resize(links_.size() + 1);
    points[0] = base_;
    if (slide_)
        points[0] += q[0] * slide_->axis;
    if (linkCount() < SineCosineBlock::worthIt)
        placeOneByOne(links_, q.data() + firstAngle(), points.data() + 1);
    else
        placeInBlocks(links_, q.data() + firstAngle(), points.data() + 1);
}

void PlanarArm::motionBounds(ConfigurationRef delta, Eigen::VectorXd &lengths, Eigen::VectorXd &bends) const
{
    lengths.resize(linkCount());
    bends.resize(linkCount());
    const double carried = slide_ ? std::abs(delta[0]) : 0.0;
    const double *turn = delta.data() + firstAngle();
    for (int i = 0; i < linkCount(); ++i)
    {
        const int parent = links_[i].parent;
        const double arc = links_[i].length * std::abs(turn[i]);
        lengths[i] = (parent < 0 ? carried : lengths[parent]) + arc;
        bends[i] = (parent < 0 ? 0.0 : bends[parent]) + arc * std::abs(turn[i]);
    }
}

void PlanarArm::velocities(const std::vector<Eigen::Vector2d> &points, ConfigurationRef delta,
                           std::vector<Eigen::Vector2d> &velocities) const
{
    velocities.resize(points.size());
    velocities[0] = slide_ ? Eigen::Vector2d(delta[0] * slide_->axis) : Eigen::Vector2d::Zero();
    const double *turn = delta.data() + firstAngle();
    for (std::size_t i = 0; i < links_.size(); ++i)
    {
        const int base = links_[i].parent + 1;
        const Eigen::Vector2d along = points[i + 1] - points[base];
        velocities[i + 1] = velocities[base] + turn[i] * Eigen::Vector2d(-along.y(), along.x());
    }
}

Eigen::VectorXd PlanarArm::toAbsolute(ConfigurationRef q, AngleConvention from) const
{
    Eigen::VectorXd absolute = q;
    if (from == AngleConvention::Relative)
        for (int i = 0; i < linkCount(); ++i)
            if (links_[i].parent >= 0)
                absolute[firstAngle() + i] += absolute[firstAngle() + links_[i].parent];
    return absolute;
}

Eigen::VectorXd PlanarArm::fromAbsolute(ConfigurationRef q, AngleConvention to) const
{
    Eigen::VectorXd converted = q;
    if (to == AngleConvention::Relative)
        for (int i = 0; i < linkCount(); ++i)
            if (links_[i].parent >= 0)
                converted[firstAngle() + i] -= q[firstAngle() + links_[i].parent];
    return converted;
}
}  // namespace narrows
