// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "BadFiles.h"
#include "scenario/Scenario.h"

// Every file of tests/data/bad has one fault, which its name tells; many_faults.yaml has many. Lines with a fault end
// in the comment "here" where the text of the file allows one.

namespace narrows
{
namespace
{
const std::string folder = NARROWS_SOURCE_DIR "/tests/data/bad/";

const std::vector<BadFile> badFiles = {
    {"format_missing", "format", "is missing"},
    {"format_other_version", "format", "must be narrows/scenario/1, not 'narrows/scenario/9'"},
    {"name_missing", "name", "is missing"},
    {"name_two_words", "name", "must be one word"},
    {"name_empty", "name", "must be a text, not nothing"},
    {"key_unknown", "sauce", "unknown key; did you mean 'source'?"},
    {"key_unknown_robot", "robot.radios", "unknown key; did you mean 'radius'?"},
    {"key_unknown_link", "robot.links[1].lenght", "unknown key; did you mean 'length'?"},
    {"key_unknown_obstacle", "obstacles[0].height", "unknown key; possible here: name, kind, center, radius"},
    {"key_twice", "robot.radius", "given twice; first in line 5"},
    {"key_twice_top", "goal", "given twice; first in line 11"},
    {"key_is_a_list", "robot", "a key must be a word, not a list of 2"},
    {"robot_missing", "robot", "is missing"},
    {"robot_not_a_mapping", "robot", "must be a mapping (key: value), not 'arm'"},
    {"kind_unknown", "robot.kind",
     "must be planar_arm or planar_chain or spatial_arm, not 'planar_arms'; did you mean 'planar_arm'?"},
    {"self_collision_word", "robot.self_collision", "must be true or false, not 'yes'"},
    {"generate_family_missing", "generate.family", "is missing"},
    {"generate_family_unknown", "generate.family", "not 'slap'; did you mean 'slab'?"},
    {"generate_parameter_unknown", "generate.width", "unknown key; did you mean 'half_width'?"},
    {"generate_parameter_bad", "generate.half_width", "must be a number from 1e-08 to 0.2, not '0'"},
    {"generate_parameters_contrary", "generate", "takes radius or clearance, not both"},
    {"generate_beside_robot", "robot", "generate makes robot, obstacles, start and goal"},
    {"generate_methods_bad", "methods.hppm.repulsion.C3", "unknown key; did you mean 'C1'?"},
    {"links_missing", "robot.links", "is missing"},
    {"links_none", "robot.links", "must be a list of 1 to 1000 entries, not a list of 0"},
    {"links_not_a_list", "robot.links", "must be a list of 1 to 1000 entries, not a mapping"},
    {"links_too_many", "robot.links", "must be a list of 1 to 1000 entries, not a list of 1001"},
    {"links_contain_themselves", "robot.links[0]", "must be a mapping (key: value), not a list of 1"},
    {"length_missing", "robot.links[1].length", "is missing"},
    {"length_zero", "robot.links[1].length", "must be positive (at least 1e-09), not '0'"},
    {"length_negative", "robot.links[1].length", "must be positive (at least 1e-09), not '-1'"},
    {"length_not_a_number", "robot.links[1].length", "must be a number, not 'one'"},
    {"length_infinite", "robot.links[1].length", "must be finite, not '.inf'"},
    {"length_nan", "robot.links[1].length", "must be finite, not '.nan'"},
    {"length_too_large_for_a_double", "robot.links[1].length", "must be finite, not '1e400'"},
    {"length_absurd", "robot.links[1].length", "must be at most 1000000000"},
    {"length_with_unit", "robot.links[1].length", "must be a number, not '1 m'"},
    {"length_null", "robot.links[1].length", "must be a number, not nothing"},
    {"parent_is_itself", "robot.links[1].parent", "must be a whole number from 0 to 1, not '2'"},
    {"parent_negative", "robot.links[1].parent", "must be a whole number from 0 to 1, not '-1'"},
    {"parent_fraction", "robot.links[1].parent", "must be a whole number from 0 to 1, not '0.5'"},
    {"radius_negative", "robot.radius", "must not be negative, but is -0.1"},
    {"angles_unknown", "robot.angles", "must be absolute or relative, not 'relativ'; did you mean 'relative'?"},
    {"limits_reversed", "robot.limits", "the lower end 1 must be less than the upper end -1"},
    {"limits_too_few", "robot.limits", "must have one entry for each of the 2 links, not 1"},
    {"limits_word", "robot.limits", "must be none, [lower, upper] or a list of these"},
    {"limits_entry_reversed", "robot.limits[1]", "the lower end 2 must be less than the upper end 1"},
    {"base_in_space", "robot.base", "must be a list of 2 entries, not a list of 3"},
    {"base_not_finite", "robot.base[1]", "must be finite, not '.nan'"},
    {"slide_on_arm", "robot.base.slide", "only a robot of kind planar_chain"},
    {"slide_missing", "robot.base.slide", "is missing"},
    {"slide_axis_zero", "robot.base.slide.axis", "must not be a zero vector"},
    {"slide_limits_reversed", "robot.base.slide.limits", "the lower end 1 must be less than the upper end -1"},
    {"slide_limits_infinite", "robot.base.slide.limits[1]", "must be finite, not '.inf'"},
    {"obstacles_missing", "obstacles", "is missing"},
    {"obstacles_not_a_list", "obstacles", "must be a list of 0 to 10000 entries, not a mapping"},
    {"obstacle_kind_missing", "obstacles[0].kind", "is missing"},
    {"obstacle_kind_in_space", "obstacles[0].kind", "must be circle or superellipse or polygon or box, not 'sphere'"},
    {"obstacle_name_twice", "obstacles[1].name", "the name 'C1' is already that of the obstacle in line 9"},
    {"obstacle_name_control_character", "obstacles[0].name", "without control characters"},
    {"circle_radius_zero", "obstacles[0].radius", "must be positive (at least 1e-09), not '0'"},
    {"circle_center_short", "obstacles[0].center", "must be a list of 2 entries, not a list of 1"},
    {"superellipse_exponent_small", "obstacles[0].exponent", "must be from 2 to 100, not 1.5"},
    {"superellipse_flat", "obstacles[0].half_extents[1]", "must be positive (at least 1e-09), not '0'"},
    {"polygon_two_vertices", "obstacles[0].vertices", "must be a list of 3 to 10000 entries, not a list of 2"},
    {"polygon_crosses_itself", "obstacles[0].vertices", "must be simple"},
    {"polygon_without_area", "obstacles[0].vertices", "must be simple"},
    {"polygon_nearly_without_area", "obstacles[0].vertices", "has no area"},
    {"polygon_vertex_repeated", "obstacles[0].vertices", "vertex 2 is repeated"},
    {"polygon_closed_twice", "obstacles[0].vertices", "vertex 3 is repeated"},
    {"polygon_vertex_text", "obstacles[0].vertices[1][0]", "must be a number, not 'x'"},
    {"box_inside_out", "obstacles[0].max", "must be greater than min"},
    {"start_missing", "start", "is missing"},
    {"start_without_state", "start", "must have angles or points"},
    {"start_not_a_mapping", "start", "must be a mapping (key: value), not a list of 2"},
    {"start_dimension", "start.angles", "must have one entry for each of the 2 links, not 3"},
    {"start_angles_and_points", "start.points", "already given by angles"},
    {"start_angle_unit", "start.angles[1]", "must be an angle (radians, or as in '42.5 deg'), not '30 degrees'"},
    {"start_angle_nan", "start.angles[0]", "must be finite, not '.nan'"},
    {"start_in_collision", "start", "in collision: link 2 touches C1"},
    {"start_in_self_collision", "start", "in collision: link 3 touches link 1"},
    {"start_out_of_limits", "start.angles[1]", "the angle 1.5 of link 2 is out of its limits [-1, 1]"},
    {"start_out_of_relative_limits", "start.points[1]", "of link 2 is out of its limits [-1, 1]"},
    {"start_points_length", "start.points[1]", "link 2 would be 1.1 long there, but its length is 1"},
    {"start_points_dimension", "start.points", "must have one entry for each of the 2 links, not 1"},
    {"start_slide_missing", "start.slide", "is missing"},
    {"start_slide_out_of_limits", "start.slide", "2 is out of the slide's limits [-1, 1]"},
    {"start_slide_without_slide", "start.slide", "the robot has no sliding base"},
    {"files_in_the_plane", "files", "only robots of kind spatial_arm have obstacles from files"},
    {"goal_missing", "goal", "is missing"},
    {"goal_without_state", "goal", "must have angles, points or tip"},
    {"goal_in_collision", "goal", "in collision: link 2 touches C1"},
    {"goal_tip_out_of_reach", "goal.tip", "out of reach: 3 away from the base, but the chain to link 2 is 2 long"},
    {"goal_tip_too_near", "goal.tip",
     "out of reach: 0.1 away from the base, but the tip of link 2 cannot come nearer than 0.5"},
    {"goal_tip_beyond_slide", "goal.tip", "out of reach: 2.5 away from the base"},
    {"goal_tip_inside_obstacle", "goal", "every point within the tolerance lies inside C1"},
    {"goal_link_unknown", "goal.link", "must be a whole number from 1 to 2, not '3'"},
    {"goal_tolerance_missing", "goal.tolerance", "is missing"},
    {"goal_tolerance_zero", "goal.tolerance", "must be positive (at least 1e-09), not '0'"},
    {"methods_not_a_mapping", "methods.hppm", "must be a mapping (key: value), not 'default'"},
    {"methods_unknown_key", "methods.hppm.repulsions", "unknown key; did you mean 'repulsion'?"},
    {"methods_repulsion_missing", "methods.hppm.repulsion.C1", "is missing"},
    {"methods_repulsion_unknown", "methods.hppm.repulsion.C2", "unknown key; did you mean 'C1'?"},
    {"methods_row_short", "methods.hppm.rows[1]", "must be a list of 2 entries, not a list of 1"},
    {"methods_too_many_rows", "methods.hppm.rows", "must be a list of 2 entries, not a list of 3"},
    {"methods_direction_short", "methods.hppm.direction", "must be a list of 2 entries, not a list of 1"},
    {"methods_rows_and_direction", "methods.hppm.direction", "rows already fix the direction"},
    {"methods_lambda_max_small", "methods.hppm.lambda_max", "must be from 1 to 10"},
    {"methods_points_per_link_zero", "methods.hppm.points_per_link", "must be a whole number from 1 to 200, not '0'"},
    {"methods_other_planner_list", "methods.rrtconnect.range", "must be a text, not a list of 1"},
    {"yaml_bracket_open", "", "is not valid YAML"},
    {"yaml_tab", "", "is not valid YAML"},
    {"yaml_alias_undefined", "", "is not valid YAML"},
    {"yaml_nested_too_deep", "", "is not valid YAML: nested too deeply"},
    {"yaml_two_documents", "", "is not one YAML document"},
    {"yaml_comma_first", "", "is not one YAML document"},
    {"yaml_bracket_too_many", "", "is not valid YAML"},
    {"yaml_list", "", "must be a mapping (key: value), not a list of 1"},
    {"yaml_text", "", "must be a mapping (key: value)"},
    {"empty", "", "is empty"},
    {"empty_lines", "", "is empty"},
    {"empty_but_comments", "", "must be a mapping (key: value), not nothing"},
    {"binary", "", "is not a text file"},
    {"utf16", "", "is not a text file"},
    {"latin1", "", "is not a text file in UTF-8"},
};

class BadScenario : public testing::TestWithParam<BadFile>
{
};

TEST_P(BadScenario, IsRefusedWithPlaceAndReason)
{
    expectRefused(folder, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Files, BadScenario, testing::ValuesIn(badFiles), nameOf);

TEST(BadScenarios, AreAllInTheTable)
{
    expectListed(folder, badFiles);
}

TEST(BadScenarios, FaultsOfOneFileAreReportedTogether)
{
    expectFaultsTogether(
        folder, {"format", "name", "authr", "robot.base[1]", "robot.links[0].length", "robot.links[1].parent",
                 "robot.radius", "robot.radius", "robot.angles", "obstacles[0].radius", "obstacles[1].vertices",
                 "obstacles[2].depth", "obstacles[2].max", "start.angles", "goal.tolerance",
                 "methods.hppm.repulsion.obstacle 3", "methods.hppm.form"});
}

TEST(BadScenarios, TheMessageHasOneLineForEveryFault)
{
    const InputError error({{"a.yaml", 3, "robot.radius", "is bad"}, {"a.yaml", 0, "", "is empty"}});
    EXPECT_STREQ(error.what(), "a.yaml:3: robot.radius: is bad\na.yaml: is empty");
}

TEST(BadScenarios, DamagedTextIsReadOrRefusedButNeverCrashes)
{
    const std::string original = contentsOf(NARROWS_SOURCE_DIR "/experiments/scenarios/gripper_slide.yaml");
    ASSERT_FALSE(original.empty());
    constexpr int rounds = 2000;
    const auto read = [](const std::string &text)
    {
        EXPECT_TRUE(parseScenario(text, "damaged").planar().model);
    };
    EXPECT_GT(damage(original, "0123456789-.:,[]{}#&*!|>'\"%@`~ \n\tae", rounds, read), rounds / 2);
}

TEST(BadScenarios, FilesThatCannotBeReadAreRefused)
{
    const std::vector<InputFault> missing = faultsOf(folder + "no such file.yaml");
    ASSERT_EQ(missing.size(), 1u);
    EXPECT_EQ(missing[0].reason, "there is no such file");
    EXPECT_EQ(missing[0].file, folder + "no such file.yaml");

    const std::vector<InputFault> directory = faultsOf(folder);
    ASSERT_EQ(directory.size(), 1u);
    EXPECT_EQ(directory[0].reason, "is a directory, not a file");

    const std::vector<InputFault> endless = faultsOf("/dev/zero");
    ASSERT_EQ(endless.size(), 1u);
    EXPECT_EQ(endless[0].reason, "is larger than 16 MiB");
}
}  // namespace
}  // namespace narrows
