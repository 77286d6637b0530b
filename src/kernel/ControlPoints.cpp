// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/ControlPoints.h"

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace narrows
{
namespace
{
/// What both classes below share.
struct Scene
{
    ControlPoints robot;
    std::vector<DistanceFunction> obstacles;

    /// Calls visit(obstacle, ball, C, its derivative in the workspace) for every pair; without derivatives if `slopes`
    /// is null.
    template <class Visit>
    void forEachPole(const Eigen::Ref<const Eigen::VectorXd> &q, std::vector<Eigen::MatrixXd> *jacobians,
                     const Visit &visit) const
    {
        const Eigen::Index balls = static_cast<Eigen::Index>(robot.radii.size());
        Eigen::MatrixXd points(robot.workspace, balls);
        if (jacobians != nullptr)
            jacobians->assign(robot.radii.size(), Eigen::MatrixXd(robot.workspace, robot.dimension));
        robot.place(q, points, jacobians);
        Eigen::VectorXd slope(robot.workspace);
        for (std::size_t i = 0; i < obstacles.size(); ++i)
            for (Eigen::Index k = 0; k < balls; ++k)
                visit(i, static_cast<std::size_t>(k),
                      obstacles[i].value(points.col(k), jacobians != nullptr ? &slope : nullptr) - robot.radii[k],
                      slope);
    }
};

class ControlPointRepulsion final : public Repulsion
{
public:
    ControlPointRepulsion(std::shared_ptr<const Scene> scene, std::vector<double> strengths)
      : scene_(std::move(scene)), strengths_(std::move(strengths))
    {
        requireStrengths(strengths_, scene_->obstacles.size(), "obstacle");
    }

    int dimension() const override { return scene_->robot.dimension; }

    void evaluate(const Eigen::Ref<const Eigen::VectorXd> &q, Sample &sample) const override
    {
        sample.value = 0.0;
        sample.gradient.setZero(dimension());
        sample.poles.clear();
        std::vector<Eigen::MatrixXd> jacobians;
        scene_->forEachPole(q, &jacobians,
                            [&](std::size_t i, std::size_t k, double pole, const Eigen::VectorXd &slope)
                            {
                                if (strengths_[i] == 0.0)
                                    return;
                                const double share = strengths_[i] / pole;
                                sample.value += share;
                                sample.gradient.noalias() -= share / pole * (jacobians[k].transpose() * slope);
                                sample.poles.push_back(pole);
                            });
    }

    double value(const Eigen::Ref<const Eigen::VectorXd> &q) const override
    {
        double sum = 0.0;
        scene_->forEachPole(q, nullptr,
                            [&](std::size_t i, std::size_t, double pole, const Eigen::VectorXd &)
                            { sum += strengths_[i] == 0.0 ? 0.0 : strengths_[i] / pole; });
        return sum;
    }

private:
    std::shared_ptr<const Scene> scene_;
    std::vector<double> strengths_;
};

class ControlPointModel final : public RepulsionModel
{
public:
    ControlPointModel(Scene scene, double length)
      : scene_(std::make_shared<const Scene>(std::move(scene))), length_(length)
    {
        for (const DistanceFunction &obstacle : scene_->obstacles)
            groups_.push_back(obstacle.name);
    }

    int dimension() const override { return scene_->robot.dimension; }
    const std::vector<std::string> &groups() const override { return groups_; }
    std::size_t obstacleCount() const override { return groups_.size(); }
    int workspace() const override { return scene_->robot.workspace; }
    double naturalStrength(std::size_t /*group*/) const override { return length_; }

    std::shared_ptr<const Repulsion> continuous(const std::vector<double> &strengths) const override
    {
        return std::make_shared<const ControlPointRepulsion>(scene_, strengths);
    }

    bool supportsPoints() const override { return true; }

    std::shared_ptr<const Repulsion> points(const std::vector<double> &strengths, int /*pointsPerLink*/) const override
    {
        return continuous(strengths);
    }

    double clearance(const Eigen::Ref<const Eigen::VectorXd> &q, Eigen::VectorXd &gradient) const override
    {
        double least = std::numeric_limits<double>::infinity();
        gradient.setZero(dimension());
        std::vector<Eigen::MatrixXd> jacobians;
        scene_->forEachPole(q, &jacobians,
                            [&](std::size_t, std::size_t k, double pole, const Eigen::VectorXd &slope)
                            {
                                if (!(pole < least))
                                    return;
                                least = pole;
                                gradient = jacobians[k].transpose() * slope;
                            });
        return least;
    }

private:
    std::shared_ptr<const Scene> scene_;
    std::vector<std::string> groups_;
    double length_;
};

void require(bool holds, const std::string &what)
{
    if (!holds)
        throw std::invalid_argument(what);
}
}  // namespace

ControlPoints pointRobot(int coordinates, double radius)
{
    const auto place = [](const auto &q, Eigen::MatrixXd &points, std::vector<Eigen::MatrixXd> *jacobians)
    {
        points.col(0) = q;
        if (jacobians != nullptr)
            jacobians->front().setIdentity();
    };
    return {coordinates, coordinates, {radius}, place};
}

std::shared_ptr<const RepulsionModel> controlPointModel(ControlPoints robot, std::vector<DistanceFunction> obstacles,
                                                        double length)
{
    require(robot.dimension > 0 && robot.workspace > 0, "a robot needs joints and a workspace");
    require(!robot.radii.empty() && robot.place, "a robot needs control points");
    for (const double radius : robot.radii)
        require(radius >= 0.0 && std::isfinite(radius), "the radii of control points must not be negative");
    std::set<std::string> names;
    for (const DistanceFunction &obstacle : obstacles)
    {
        require(static_cast<bool>(obstacle.value), "obstacle \"" + obstacle.name + "\" has no function");
        require(names.insert(obstacle.name).second, "two obstacles are called \"" + obstacle.name + "\"");
    }
    require(length > 0.0 && std::isfinite(length), "the ordinary distance must be positive");
    return std::make_shared<const ControlPointModel>(Scene{std::move(robot), std::move(obstacles)}, length);
}
}  // namespace narrows
