// SPDX-License-Identifier: BSD-3-Clause
// OMPL's own tests of planners in the plane, their files as they are (tests/geometric/2d/2denvs.cpp, which includes
// tests/base/PlannerTest.h), with our planners for a point robot: option NARROWS_OMPL_SOURCE, docs/reuse.md.
//
// 2denvs.cpp brings the test module and a case for each of OMPL's planners; those of this file are the suite Narrows.
#include "geometric/2d/2denvs.cpp"

#include "kernel/ControlPoints.h"
#include "planners/HPPM.h"
#include "planners/Threader.h"
#include "planners/TightManeuvering.h"
#include "planners/VDSM.h"
#include "planners/ViaPointHomotopy.h"

namespace
{
using Point = Eigen::Ref<const Eigen::VectorXd>;

narrows::DistanceFunction disc(const std::string &name, const Eigen::Vector2d &center, double radius)
{
    return {name, [center, radius](const Point &point, Eigen::VectorXd *gradient)
            {
                const Eigen::Vector2d apart = point - center;
                if (gradient != nullptr)
                    *gradient = apart.normalized();
                return apart.norm() - radius;
            }};
}

/// The signed distance of an upright box.
narrows::DistanceFunction box(const std::string &name, const Eigen::Vector2d &low, const Eigen::Vector2d &high)
{
    return {name, [low, high](const Point &point, Eigen::VectorXd *gradient)
            {
                const Eigen::Vector2d middle = 0.5 * (low + high), apart = point - middle;
                const Eigen::Vector2d beyond = apart.cwiseAbs() - 0.5 * (high - low);
                const Eigen::Vector2d side(apart.x() < 0.0 ? -1.0 : 1.0, apart.y() < 0.0 ? -1.0 : 1.0);
                const Eigen::Vector2d outside = beyond.cwiseMax(0.0);
                const Eigen::Vector2d slope = outside.norm() > 0.0      ? Eigen::Vector2d(outside.normalized())
                                              : beyond.x() > beyond.y() ? Eigen::Vector2d(1.0, 0.0)
                                                                        : Eigen::Vector2d(0.0, 1.0);
                if (gradient != nullptr)
                    *gradient = slope.cwiseProduct(side);
                return outside.norm() > 0.0 ? outside.norm() : beyond.maxCoeff();
            }};
}

/// Is every cell from (i, j) to (last, end), both included, occupied?
bool occupied(const Environment2D &map, int i, int j, int last, int end)
{
    for (int x = i; x <= last; ++x)
        for (int y = j; y <= end; ++y)
            if (x >= map.width || y >= map.height || map.grid[x][y] != T_OBSTACLE)
                return false;
    return true;
}

/// The occupied cells as boxes: each as wide, then as high as it gets.
std::vector<narrows::DistanceFunction> boxesOf(Environment2D map)
{
    std::vector<narrows::DistanceFunction> result;
    for (int i = 0; i < map.width; ++i)
        for (int j = 0; j < map.height; ++j)
        {
            if (map.grid[i][j] != T_OBSTACLE)
                continue;
            int last = i, end = j;
            while (occupied(map, i, j, i, end + 1))
                ++end;
            while (occupied(map, i, j, last + 1, end))
                ++last;
            result.push_back(box("box" + std::to_string(result.size()), {i, j}, {last + 1, end + 1}));
            for (int x = i; x <= last; ++x)
                for (int y = j; y <= end; ++y)
                    map.grid[x][y] = T_PATH;
        }
    return result;
}

/// What stands in the environment that a space was made for: upstream's planners never learn it, ours must.
std::vector<narrows::DistanceFunction> obstaclesOf(const base::SpaceInformationPtr &si)
{
    const std::string resources = TEST_RESOURCES_DIR;
    if (dynamic_cast<const geometric::StateValidityChecker2DCircles *>(si->getStateValidityChecker().get()) == nullptr)
    {
        Environment2D map;
        loadEnvironment((resources + "/env1.txt").c_str(), map);
        return boxesOf(map);
    }
    Circles2D circles;
    circles.loadCircles(resources + "/circle_obstacles.txt");
    std::vector<narrows::DistanceFunction> result;
    for (const Circles2D::Circle &circle : circles.circles_)
        result.push_back(disc("disc" + std::to_string(result.size()), {circle.x_, circle.y_}, circle.r_));
    return result;
}

std::shared_ptr<const narrows::RepulsionModel> modelOf(const base::SpaceInformationPtr &si)
{
    return narrows::controlPointModel(narrows::pointRobot(2), obstaclesOf(si), 2.0);
}

class HPPMTest : public TestPlanner
{
    base::PlannerPtr newPlanner(const base::SpaceInformationPtr &si) override
    {
        return std::make_shared<narrows::HPPM>(si, modelOf(si));
    }
};

class ViaPointHomotopyTest : public TestPlanner
{
    base::PlannerPtr newPlanner(const base::SpaceInformationPtr &si) override
    {
        return std::make_shared<narrows::ViaPointHomotopy>(si, false);
    }
};
}  // namespace

BOOST_FIXTURE_TEST_SUITE(Narrows, PlanTest)

// Success and seconds that upstream asks of its trees.
OMPL_PLANNER_TEST(HPPM, 95.0, 0.01)
OMPL_PLANNER_TEST(ViaPointHomotopy, 95.0, 0.01)

// The others are for arms, and say so by status.
BOOST_AUTO_TEST_CASE(geometric_Refusals)
{
    geometric::SimpleSetup2DMap setup(env_);
    const base::SpaceInformationPtr &si = setup.getSpaceInformation();
    const std::vector<std::shared_ptr<narrows::ModelPlanner>> planners{
        std::make_shared<narrows::Threader>(si, nullptr, nullptr, nullptr),
        std::make_shared<narrows::TightManeuvering>(si, nullptr, nullptr),
        std::make_shared<narrows::VDSM>(si, nullptr)};
    for (const auto &planner : planners)
    {
        setup.setPlanner(planner);
        BOOST_CHECK(setup.solve(SOLUTION_TIME) == base::PlannerStatus::ABORT);
        BOOST_CHECK_EQUAL(planner->reason(), "space");
    }
}

BOOST_AUTO_TEST_SUITE_END()
