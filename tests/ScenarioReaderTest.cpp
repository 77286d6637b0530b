// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenario/Scenario.h"
#include "validity/PlanarChecker.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::VectorXd;

const std::string folder = NARROWS_SOURCE_DIR "/experiments/scenarios/";

const VectorXd &goalState(const Scenario &scenario)
{
    return std::get<VectorXd>(scenario.planar().task.goal);
}

double clearance(const Scenario &scenario, const VectorXd &q)
{
    const PlanarArm &arm = scenario.planar().model->arm;
    const auto checker = makeAnalyticChecker(*scenario.planar().model);
    std::vector<Vector2d> points;
    arm.place(q, points);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < arm.links().size(); ++i)
        least = std::min(least, checker->clearance({points[static_cast<std::size_t>(arm.links()[i].parent + 1)],
                                                    points[i + 1], arm.radius()}));
    return least;
}

std::vector<VectorXd> parseRows(const std::string &text)
{
    std::vector<VectorXd> rows;
    std::istringstream stream(text);
    for (std::string row; std::getline(stream, row, ';');)
    {
        std::vector<double> values;
        std::istringstream numbers(row);
        for (std::string number; std::getline(numbers, number, ',');)
            values.push_back(std::stod(number));
        rows.push_back(VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size())));
    }
    return rows;
}

/// The paper prints a_0 = -a . w_goal cut off after two decimals.
void expectPrintedConstants(const std::vector<VectorXd> &rows, const VectorXd &goal, const std::vector<double> &printed)
{
    ASSERT_EQ(rows.size(), printed.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        EXPECT_NEAR(std::trunc(-rows[i].dot(goal) * 100.0) / 100.0, printed[i], 1e-9) << "row " << i + 1;
}

/// A file with two links of length 1 and one circle out of the way; the arguments replace its parts.
std::string smallFile(const std::string &robot, const std::string &start,
                      const std::string &goal = "{tip: [1, 1], tolerance: 0.1}",
                      const std::string &obstacles = "[{kind: circle, center: [0, 9], radius: 1}]")
{
    return "format: narrows/scenario/1\nname: small\nrobot: {kind: planar_arm, links: [{length: 1}, {length: 1}]" +
           robot + "}\nobstacles: " + obstacles + "\nstart: " + start + "\ngoal: " + goal + "\n";
}

TEST(ScenarioReader, ReadsCase1)
{
    const Scenario scenario = readScenario(folder + "hppm_case1.yaml");
    EXPECT_EQ(scenario.name, "hppm-case-1");
    EXPECT_THAT(scenario.source, testing::HasSubstr("Table 1"));
    EXPECT_EQ(scenario.planar().convention, AngleConvention::Absolute);
    EXPECT_THAT(scenario.text, testing::HasSubstr("points_per_link: 5"));

    const PlanarArm &arm = scenario.planar().model->arm;
    ASSERT_EQ(arm.linkCount(), 3);
    EXPECT_DOUBLE_EQ(arm.links()[0].length, std::sqrt(5.0));
    EXPECT_EQ(arm.links()[0].parent, -1);
    EXPECT_EQ(arm.links()[2].parent, 1);
    EXPECT_EQ(arm.radius(), 0.0);
    EXPECT_FALSE(arm.slide());

    EXPECT_TRUE(scenario.planar().task.start.isApprox(Eigen::Vector3d(std::atan(0.5), -M_PI / 4, M_PI / 4), 1e-15));
    EXPECT_TRUE(goalState(scenario).isApprox(Eigen::Vector3d(std::atan(2.0), M_PI / 4, M_PI / 4), 1e-15));
    EXPECT_NEAR(clearance(scenario, scenario.planar().task.start), 0.972, 5e-4);
    EXPECT_NEAR(clearance(scenario, goalState(scenario)), 0.0564, 5e-5);

    const auto &hppm = scenario.methods.at("hppm");
    EXPECT_EQ(hppm.at("points_per_link"), "5");
    EXPECT_EQ(hppm.at("repulsion"), "-0.1, 0.1");
    EXPECT_EQ(hppm.at("rows"), "1, 3, 2; 1, -1, 4; 1, 1, -2");
    expectPrintedConstants(parseRows(hppm.at("rows")), goalState(scenario), {-5.03, -3.46, -0.32});
}

TEST(ScenarioReader, ReadsCase2)
{
    const Scenario scenario = readScenario(folder + "hppm_case2.yaml");
    const PlanarArm &arm = scenario.planar().model->arm;
    ASSERT_EQ(arm.linkCount(), 8);
    EXPECT_EQ(arm.links()[6].parent, 5);
    EXPECT_EQ(arm.links()[7].parent, 5);
    const auto &wall = std::get<Superellipse>(scenario.planar().model->obstacles[1].shape);
    EXPECT_TRUE(wall.halfExtents.array().pow(4.0).isApprox(Eigen::Array2d(15.0, 0.05), 1e-14));
    EXPECT_EQ(wall.exponent, 4.0);

    std::vector<Vector2d> points;
    arm.place(goalState(scenario), points);
    EXPECT_LT((points[7] - Vector2d(4.05, 6.75)).norm(), 0.01) << "the tip of the first finger as printed";
    EXPECT_LT((points[8] - Vector2d(4.05, 6.25)).norm(), 0.01) << "the tip of the second finger as printed";
    EXPECT_NEAR(clearance(scenario, scenario.planar().task.start), 2.061, 5e-4);
    EXPECT_NEAR(clearance(scenario, goalState(scenario)), 0.0155, 5e-5);
    EXPECT_EQ(scenario.methods.at("hppm").at("lambda_max"), "1.5");
    expectPrintedConstants(parseRows(scenario.methods.at("hppm").at("rows")), goalState(scenario),
                           {-13.05, -6.26, 9.19, -5.73, -21.87, 0.00, -13.88, -20.24});
}

TEST(ScenarioReader, ReadsCase3)
{
    const Scenario scenario = readScenario(folder + "hppm_case3.yaml");
    ASSERT_EQ(scenario.planar().model->arm.linkCount(), 20);
    ASSERT_EQ(scenario.planar().model->obstacles.size(), 7u);
    EXPECT_NEAR(clearance(scenario, scenario.planar().task.start), 0.270, 5e-4);
    EXPECT_NEAR(clearance(scenario, goalState(scenario)), 0.1239, 5e-5);

    // The two rows that the paper prints (Table 3).
    const std::vector<VectorXd> printed = parseRows(
        "1, 1, 2, 3, 4, 5, 5, 4, 3, 2, 1, -5, -4, -3, -2, -1, -1, -2, -3, -4;"
        "1, -1, 9, 7, -2, 1, -5, -4, -3, 6, -1, 5, 3, -6, -8, 1, -10, 2, 3, 8");
    expectPrintedConstants(printed, goalState(scenario), {-42.41, 18.84});
    const VectorXd direction = parseRows(scenario.methods.at("hppm").at("direction")).at(0);
    ASSERT_EQ(direction.size(), 20);
    EXPECT_NEAR(direction.norm(), 1.0, 1e-7);
    for (const VectorXd &row : printed)
        EXPECT_NEAR(row.dot(direction), 0.0, 1e-6);
    EXPECT_EQ(scenario.methods.at("hppm").at("orientation"), "decreasing");
}

TEST(ScenarioReader, ReadsAChainWithSlideLimitsAndTipGoal)
{
    const Scenario scenario = readScenario(folder + "gripper_slide.yaml");
    const PlanarArm &arm = scenario.planar().model->arm;
    ASSERT_TRUE(arm.slide());
    EXPECT_EQ(arm.slide()->lower, -1.5);
    EXPECT_EQ(arm.dimension(), 6);
    EXPECT_EQ(arm.radius(), 0.04);
    EXPECT_EQ(scenario.planar().convention, AngleConvention::Relative);
    EXPECT_EQ(scenario.planar().task.limits.convention, AngleConvention::Relative);
    EXPECT_DOUBLE_EQ(scenario.planar().task.limits.angles[1]->upper, M_PI * 2.0 / 3.0);

    VectorXd expected(6);
    expected << -1.2, 10, 15, 15, 35, -5;  // relative 10, 5, 0, 20 and -20 degrees
    expected.tail(5) *= M_PI / 180.0;
    EXPECT_TRUE(scenario.planar().task.start.isApprox(expected, 1e-14)) << scenario.planar().task.start.transpose();
    const auto &goal = std::get<TipGoal>(scenario.planar().task.goal);
    EXPECT_EQ(goal.link, 2);
    EXPECT_EQ(goal.point, Vector2d(0.2, 2.6));
    EXPECT_EQ(goal.tolerance, 0.05);
    EXPECT_EQ(std::get<Polygon>(scenario.planar().model->obstacles[0].shape).vertices.size(), 4u);
    EXPECT_TRUE(scenario.methods.empty());
}

TEST(ScenarioReader, EveryScenarioOfTheProjectIsSoundAndHasItsOwnName)
{
    std::set<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(folder))
    {
        if (entry.path().extension() != ".yaml")
            continue;
        EXPECT_TRUE(names.insert(readScenario(entry.path().string()).name).second) << entry.path();
    }
    EXPECT_GE(names.size(), 5u);
}

TEST(ScenarioReader, FillsInDefaults)
{
    const Scenario scenario = parseScenario(smallFile("", "{angles: [0, 90 deg]}"), "text");
    EXPECT_EQ(scenario.planar().model->arm.base(), Vector2d::Zero());
    EXPECT_EQ(scenario.planar().model->obstacles[0].name, "obstacle 1");
    EXPECT_EQ(scenario.source, "");
    ASSERT_EQ(scenario.planar().task.limits.angles.size(), 2u);
    EXPECT_FALSE(scenario.planar().task.limits.angles[0]);
    EXPECT_EQ(std::get<TipGoal>(scenario.planar().task.goal).link, 1) << "the last link";
}

TEST(ScenarioReader, PolygonsAreStoredCounterClockwise)
{
    const std::string clockwise = "[{kind: polygon, vertices: [[5, 5], [5, 6], [6, 5]]}]";
    const Scenario scenario = parseScenario(smallFile("", "{angles: [0, 0]}", "{angles: [1, 1]}", clockwise), "text");
    const auto &v = std::get<Polygon>(scenario.planar().model->obstacles[0].shape).vertices;
    const Vector2d a = v[1] - v[0];
    const Vector2d b = v[2] - v[1];
    EXPECT_GT(a.x() * b.y() - a.y() * b.x(), 0.0);
}

TEST(ScenarioReader, AnglesOfPointsLieAboveMinusPi)
{
    const Scenario scenario = parseScenario(smallFile("", "{points: [[-1, 0], [-2, -0.0]]}"), "text");
    EXPECT_EQ(scenario.planar().task.start, Vector2d(M_PI, M_PI)) << "not -pi, which atan2 gives for a negative zero";
}

TEST(ScenarioReader, PointsTakeTheTurnThatIsWithinLimits)
{
    // Straight down is -90 degrees or 270; only the latter is allowed.
    const std::string down = "{points: [[0, -1], [0, -2]]}";
    const Scenario absolute = parseScenario(smallFile(", limits: [0, 360 deg]", down), "text");
    EXPECT_TRUE(absolute.planar().task.start.isApprox(Vector2d(1.5 * M_PI, 1.5 * M_PI), 1e-15));

    const Scenario relative =
        parseScenario(smallFile(", angles: relative, limits: [[0, 360 deg], [-1, 1]]", down), "text");
    EXPECT_TRUE(relative.planar().task.start.isApprox(Vector2d(1.5 * M_PI, 1.5 * M_PI), 1e-15));
}

TEST(ScenarioReader, PrintedPointsMayBeRoundedALittle)
{
    EXPECT_NO_THROW(parseScenario(smallFile("", "{points: [[1.0049, 0], [2, 0]]}"), "text"));
    EXPECT_THROW(parseScenario(smallFile("", "{points: [[1.0051, 0], [2, 0]]}"), "text"), InputError);
}

TEST(ScenarioReader, TheRadiusCountsInCollisions)
{
    const std::string ball = "[{kind: circle, center: [1, 0.3], radius: 0.2}]";
    EXPECT_NO_THROW(parseScenario(smallFile(", radius: 0.09", "{angles: [0, 0]}", "{angles: [-1, 0]}", ball), "text"));
    EXPECT_THROW(parseScenario(smallFile(", radius: 0.11", "{angles: [0, 0]}", "{angles: [-1, 0]}", ball), "text"),
                 InputError);
}

TEST(ScenarioReader, TheAxisOfASlideIsNormalised)
{
    const Scenario scenario = parseScenario(
        "format: narrows/scenario/1\nname: slide\n"
        "robot: {kind: planar_chain, links: [{length: 1}], base: {origin: [1, 0], slide: {axis: [3, 4], limits: [0, "
        "5]}}}\n"
        "obstacles: []\nstart: {slide: 5, points: [[5, 4]]}\ngoal: {tip: [2, 0], tolerance: 0.1}\n",
        "text");
    EXPECT_TRUE(scenario.planar().model->arm.slide()->axis.isApprox(Vector2d(0.6, 0.8), 1e-15));
    EXPECT_TRUE(scenario.planar().task.start.isApprox(Vector2d(5.0, 0.0), 1e-15));
}

TEST(ScenarioReader, OtherPlannersTakeAnyScalar)
{
    const Scenario scenario =
        parseScenario(smallFile("", "{angles: [0, 0]}") + "methods: {rrtconnect: {range: 0.50, mode: fast}}\n", "text");
    EXPECT_EQ(scenario.methods.at("rrtconnect").at("range"), "0.50") << "as written";
    EXPECT_EQ(scenario.methods.at("rrtconnect").at("mode"), "fast");
}
}  // namespace
}  // namespace narrows
