// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/InterpolatingSplines.h"

#include <cmath>

#include <Eigen/SparseLU>

#include "kernel/trajectory/TimedPoints.h"

namespace narrows
{
namespace
{
constexpr double largestResidual = 1e-9;  // of the largest coordinate

/// k-th derivative of x^j at x.
double derivedPower(int j, int k, double x)
{
    double factor = 1.0;
    for (int i = 0; i < k; ++i)
        factor *= j - i;
    return j < k ? 0.0 : factor * (j == k ? 1.0 : std::pow(x, j - k));
}

/// Conditions on the coefficients of all pieces, each piece over its own x from 0 to 1.
class SplineSystem
{
public:
    SplineSystem(int degree, const Eigen::MatrixXd &points, const std::vector<double> &times)
      : degree_(degree), pieces_(static_cast<int>(points.cols()) - 1), points_(points), times_(times)
    {
        right_.setZero(size(), points.rows());
        interpolate();
        for (int knot = 1; knot < pieces_; ++knot)
            for (int order = 1; order < degree_; ++order)
            {
                addTerms(knot - 1, order, 1.0, 1.0);
                addTerms(knot, order, 0.0, -std::pow(length(knot - 1) / length(knot), order));
                ++row_;
            }
        for (int order = 1; order <= (degree_ - 1) / 2; ++order)
        {
            addTerms(0, order, 0.0, 1.0);
            ++row_;
            addTerms(pieces_ - 1, order, 1.0, 1.0);
            ++row_;
        }
    }

    OrFailure<PolynomialTrajectory> solved() const
    {
        Eigen::SparseMatrix<double> matrix(size(), size());
        matrix.setFromTriplets(terms_.begin(), terms_.end());
        const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
        if (factors.info() != Eigen::Success)
            return TrajectoryFailure::Singular;
        const Eigen::MatrixXd solution = factors.solve(right_);
        const double residual = (matrix * solution - right_).cwiseAbs().maxCoeff();
        if (!(residual <= largestResidual * std::max(1e-300, points_.cwiseAbs().maxCoeff())))
            return TrajectoryFailure::Singular;
        return trajectory(solution);
    }

private:
    int size() const { return pieces_ * (degree_ + 1); }
    double length(int piece) const
    {
        return times_[static_cast<std::size_t>(piece) + 1] - times_[static_cast<std::size_t>(piece)];
    }

    void addTerms(int piece, int order, double x, double factor)
    {
        for (int j = order; j <= degree_; ++j)
            if (const double value = factor * derivedPower(j, order, x); value != 0.0)
                terms_.emplace_back(row_, piece * (degree_ + 1) + j, value);
    }

    void interpolate()
    {
        for (int piece = 0; piece < pieces_; ++piece)
            for (const int end : {0, 1})
            {
                addTerms(piece, 0, end, 1.0);
                right_.row(row_++) = points_.col(piece + end).transpose();
            }
    }

    PolynomialTrajectory trajectory(const Eigen::MatrixXd &solution) const
    {
        std::vector<PolynomialTrajectory::Piece> pieces;
        for (int piece = 0; piece < pieces_; ++piece)
        {
            Eigen::MatrixXd coefficients = solution.middleRows(piece * (degree_ + 1), degree_ + 1).transpose();
            for (int j = 1; j <= degree_; ++j)
                coefficients.col(j) /= std::pow(length(piece), j);
            pieces.push_back({length(piece), std::move(coefficients)});
        }
        return PolynomialTrajectory(std::move(pieces));
    }

    int degree_, pieces_;
    const Eigen::MatrixXd &points_;
    const std::vector<double> &times_;
    int row_ = 0;
    std::vector<Eigen::Triplet<double>> terms_;
    Eigen::MatrixXd right_;
};

OrFailure<PolynomialTrajectory> spline(int degree, const Eigen::MatrixXd &points, const std::vector<double> &times)
{
    if (const TrajectoryFailure fault = faultOf(points, times); fault != TrajectoryFailure::None)
        return fault;
    return SplineSystem(degree, points, times).solved();
}
}  // namespace

OrFailure<PolynomialTrajectory> cubicSpline(const Eigen::MatrixXd &points, const std::vector<double> &times)
{
    return spline(3, points, times);
}

OrFailure<PolynomialTrajectory> quinticSpline(const Eigen::MatrixXd &points, const std::vector<double> &times)
{
    return spline(5, points, times);
}

OrFailure<PolynomialTrajectory> sixthOrder(const Eigen::MatrixXd &points, const std::vector<double> &times)
{
    if (points.cols() != 3)
        return TrajectoryFailure::BadCount;
    if (const TrajectoryFailure fault = faultOf(points, times); fault != TrajectoryFailure::None)
        return fault;
    // The quintic step to the goal, and as much of x^3 (1 - x)^3 as the via asks for.
    const double T = times[2], x = times[1] / T, step = x * x * x * (10.0 + x * (6.0 * x - 15.0));
    const Eigen::VectorXd way = points.col(2) - points.col(0);
    const Eigen::VectorXd bulge = (points.col(1) - points.col(0) - step * way) / std::pow(x * (1.0 - x), 3);
    Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(points.rows(), 7);
    coefficients.col(0) = points.col(0);
    coefficients.col(3) = (10.0 * way + bulge) / std::pow(T, 3);
    coefficients.col(4) = (-15.0 * way - 3.0 * bulge) / std::pow(T, 4);
    coefficients.col(5) = (6.0 * way + 3.0 * bulge) / std::pow(T, 5);
    coefficients.col(6) = -bulge / std::pow(T, 6);
    return PolynomialTrajectory({{T, std::move(coefficients)}});
}
}  // namespace narrows
