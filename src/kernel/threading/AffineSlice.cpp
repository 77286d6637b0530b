// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/AffineSlice.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace narrows
{
Eigen::MatrixXd cosineModes(int links, int count, int offset)
{
    if (count < 0 || count > links || offset < 0)
        throw std::invalid_argument("there are as many cosine modes as links");
    Eigen::MatrixXd modes = Eigen::MatrixXd::Zero(offset + links, count);
    for (int k = 0; k < count; ++k)
        for (int i = 0; i < links; ++i)
            modes(offset + i, k) = std::cos(M_PI * k * (i + 0.5) / links);
    return modes;
}

AffineSlices affineSlices(const Eigen::VectorXd &start, const Eigen::VectorXd &goal, const Eigen::MatrixXd &modes,
                          int most)
{
    constexpr double leastRemainder = 0.01;
    if (goal.size() != start.size() || modes.rows() != start.size() || most < 1)
        throw std::invalid_argument("a slice needs start, goal and modes of one size, and a dimension");
    Eigen::MatrixXd basis(start.size(), std::min<Eigen::Index>(most, start.size()));
    Eigen::Index count = 0;
    const auto add = [&](Eigen::VectorXd direction)
    {
        const double length = direction.norm();
        for (Eigen::Index i = 0; i < count; ++i)
            direction -= basis.col(i).dot(direction) * basis.col(i);
        if (direction.norm() > leastRemainder * length)
            basis.col(count++) = direction.normalized();
    };
    add(goal - start);
    for (Eigen::Index k = 0; k < modes.cols() && count < basis.cols(); ++k)
        add(modes.col(k));
    return {start, basis.leftCols(count)};
}
}  // namespace narrows
