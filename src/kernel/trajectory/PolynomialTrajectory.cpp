// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/PolynomialTrajectory.h"

#include <algorithm>
#include <stdexcept>

namespace narrows
{
namespace
{
/// The polynomial of h = x - `about`.
Eigen::VectorXd shifted(Eigen::VectorXd coefficients, double about)
{
    const Eigen::Index degree = coefficients.size() - 1;
    for (Eigen::Index from = 0; from < degree; ++from)
        for (Eigen::Index k = degree; k-- > from;)
            coefficients[k] += about * coefficients[k + 1];
    return coefficients;
}

Eigen::VectorXd derivative(const Eigen::VectorXd &coefficients)
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero(std::max<Eigen::Index>(1, coefficients.size() - 1));
    for (Eigen::Index k = 1; k < coefficients.size(); ++k)
        result[k - 1] = static_cast<double>(k) * coefficients[k];
    return result;
}

/// All values for h in [-reach, reach].
Enclosure around(const Eigen::VectorXd &coefficients, double reach)
{
    Enclosure sum = coefficients[0];
    double power = reach;
    for (Eigen::Index k = 1; k < coefficients.size(); ++k, power *= reach)
        sum = sum + coefficients[k] * Enclosure(k % 2 == 0 ? 0.0 : -power, power);
    return sum;
}
}  // namespace

class PolynomialTrajectory::Joint : public PiecewiseMotion
{
public:
    Joint(const PolynomialTrajectory &trajectory, Eigen::Index index) : trajectory_(trajectory), index_(index) {}

    std::vector<double> knots() const override { return trajectory_.knots_; }

    Series<4, Enclosure> over(std::size_t piece, const Enclosure &t) const override
    {
        const double middle = 0.5 * (t.lower + t.upper), reach = 0.5 * (t.upper - t.lower);
        Eigen::VectorXd polynomial = shifted(trajectory_.pieces_[piece].coefficients.row(index_).transpose(),
                                             middle - trajectory_.knots_[piece]);
        Series<4, Enclosure> result{};
        for (std::size_t order = 0; order < result.size(); ++order)
        {
            if (order > 0)
                polynomial = derivative(polynomial);
            result[order] = around(polynomial, reach);
        }
        return result;
    }

private:
    const PolynomialTrajectory &trajectory_;
    Eigen::Index index_;
};

PolynomialTrajectory::PolynomialTrajectory(std::vector<Piece> pieces) : pieces_(std::move(pieces)), knots_{0.0}
{
    if (pieces_.empty())
        throw std::invalid_argument("a trajectory needs a piece");
    for (const Piece &piece : pieces_)
    {
        if (!(piece.duration > 0.0) || !std::isfinite(piece.duration) || piece.coefficients.size() == 0 ||
            !piece.coefficients.allFinite() || piece.coefficients.rows() != joints())
            throw std::invalid_argument(
                "a piece of a trajectory needs a duration, and finite polynomials for the same "
                "joints as the others");
        if (!(knots_.back() + piece.duration > knots_.back()))
            throw std::invalid_argument("a piece of a trajectory is too short to be told from its beginning");
        knots_.push_back(knots_.back() + piece.duration);
    }
}

void PolynomialTrajectory::at(double t, States &state) const
{
    const double time = std::clamp(t, 0.0, duration());
    const auto next = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, time);
    const std::size_t index = static_cast<std::size_t>(next - knots_.begin()) - 1;
    const Eigen::MatrixXd &coefficients = pieces_[index].coefficients;
    const double x = time - knots_[index];
    state.setZero(joints(), 4);
    // Horner's scheme for a polynomial and its derivatives, each over its factorial.
    for (Eigen::Index k = coefficients.cols(); k-- > 0;)
    {
        for (Eigen::Index order = 3; order > 0; --order)
            state.col(order) = x * state.col(order) + state.col(order - 1);
        state.col(0) = x * state.col(0) + coefficients.col(k);
    }
    state.col(2) *= 2.0;
    state.col(3) *= 6.0;
    if (t < 0.0 || t > duration())
        state.rightCols(3).setZero();
}

std::unique_ptr<PiecewiseMotion> PolynomialTrajectory::joint(Eigen::Index index) const
{
    return std::make_unique<Joint>(*this, index);
}

PolynomialTrajectory PolynomialTrajectory::stretched(double factor) const
{
    std::vector<Piece> pieces = pieces_;
    for (Piece &piece : pieces)
    {
        piece.duration *= factor;
        double power = 1.0;
        for (Eigen::Index k = 1; k < piece.coefficients.cols(); ++k)
            piece.coefficients.col(k) *= power /= factor;
    }
    return PolynomialTrajectory(std::move(pieces));
}
}  // namespace narrows
