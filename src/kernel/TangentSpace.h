// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/QR>

namespace narrows
{
/// What a curve's tracker asks of its Jacobian J, n x (n + 1) of full rank: the direction that J leaves free and the
/// shortest solution of J x = r, both from one factorization of J's transpose.
/// \tparam Unknowns n + 1, or Eigen::Dynamic
template <int Unknowns>
class TangentSpace
{
public:
    using Vector = Eigen::Matrix<double, Unknowns, 1>;

    /// False if J is not finite or its rows are dependent.
    bool factor(const Eigen::MatrixXd &jacobian)
    {
        qr_.compute(jacobian.transpose());
        const double largest = qr_.matrixQR().diagonal().cwiseAbs().maxCoeff();
        const double smallest = qr_.matrixQR().diagonal().cwiseAbs().minCoeff();
        // Written so that a NaN is refused too.
        return jacobian.allFinite() && smallest > 1e-14 * largest;
    }

    void solve(const Eigen::VectorXd &residual, Vector &update) const
    {
        const Eigen::Index n = residual.size();
        update.resize(n + 1);
        update.head(n) = qr_.matrixQR().topRows(n).template triangularView<Eigen::Upper>().transpose().solve(residual);
        update[n] = 0.0;
        update.applyOnTheLeft(qr_.householderQ());
    }

    /// The unit vector t with J t = 0 for which the augmented determinant det(J; t') is positive.
    void tangent(Vector &t) const
    {
        const Eigen::Index n = qr_.cols();
        t = Vector::Unit(n + 1, n);
        t.applyOnTheLeft(qr_.householderQ());
        bool negative = false;
        for (Eigen::Index i = 0; i < n; ++i)
        {
            negative ^= qr_.hCoeffs()[i] != 0.0;  // a reflection
            negative ^= qr_.matrixQR()(i, i) < 0.0;
        }
        if (negative)
            t = -t;
    }

    /// The augmented determinant for that tangent: sqrt(det(J J')).
    double determinant() const { return std::abs(qr_.matrixQR().diagonal().prod()); }

private:
    static constexpr int equations = Unknowns == Eigen::Dynamic ? Eigen::Dynamic : Unknowns - 1;
    Eigen::HouseholderQR<Eigen::Matrix<double, Unknowns, equations>> qr_;
};

/// One equation in two unknowns: J is a gradient, the tangent stands upright on it.
template <>
class TangentSpace<2>
{
public:
    using Vector = Eigen::Vector2d;

    bool factor(const Eigen::MatrixXd &jacobian)
    {
        gradient_ = {jacobian(0, 0), jacobian(0, 1)};
        squared_ = gradient_.squaredNorm();
        return squared_ > 0.0 && std::isfinite(squared_);
    }
    void solve(const Eigen::VectorXd &residual, Vector &update) const { update = residual[0] / squared_ * gradient_; }
    void tangent(Vector &t) const { t = Vector(-gradient_.y(), gradient_.x()) / determinant(); }
    double determinant() const { return std::sqrt(squared_); }

private:
    Vector gradient_;
    double squared_ = 0.0;
};
}  // namespace narrows
