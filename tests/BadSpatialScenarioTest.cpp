// SPDX-License-Identifier: BSD-3-Clause
#include "BadFiles.h"

// As BadScenarioTest, with robots in space: every file of tests/data/bad_spatial has one fault.

namespace narrows
{
namespace
{
const std::string folder = NARROWS_SOURCE_DIR "/tests/data/bad_spatial/";

const std::vector<BadFile> badFiles = {
    {"axis_unknown", "robot.base.slide.axis", "must be x or y or z, not 'u'"},
    {"base_in_plane", "robot.base", "must be a list of 3 entries, not a list of 2"},
    {"base_rotation_angle_missing", "robot.base.rotation.angle", "is missing"},
    {"base_without_origin", "robot.base.origin", "is missing"},
    {"box_inside_out", "obstacles[0].max", "must be greater than min in all three coordinates"},
    {"box_rotation_word", "obstacles[0].rotation", "must be a mapping (key: value), not '30 deg'"},
    {"capsule_to_missing", "obstacles[0].to", "is missing"},
    {"capsule_without_length", "obstacles[0].to",
     "must differ from the point `from` (a capsule without length is a sphere)"},
    {"cylinder_axis_in_plane", "obstacles[0].axis", "must be a list of 3 entries, not a list of 2"},
    {"cylinder_length_infinity", "obstacles[0].length", "must be finite, not 'infinity'"},
    {"cylinder_length_missing", "obstacles[0].length", "is missing"},
    {"dh_all_zero", "robot.links", "no link has a length: give some of them d or a"},
    {"dh_limits_reversed", "robot.links[1].limits", "the lower end 1 must be less than the upper end -1"},
    {"dh_number_infinite", "robot.links[1].a", "must be finite, not '.inf'"},
    {"files_not_named", "files.lid.obj", "unknown key; did you mean 'lip.obj'?"},
    {"goal_link_without_tip", "goal.link", "has no length of its own (neither d nor a), so that it has no tip"},
    {"goal_tip_beyond_slide", "goal.tip", "out of reach: 3 away from the base, but the chain to link 2 is 2 long"},
    {"goal_tip_in_plane", "goal.tip", "must be a list of 3 entries, not a list of 2"},
    {"goal_tip_inside_a_mesh", "goal", "in collision: every point within the tolerance lies inside C"},
    {"goal_tip_inside_obstacle", "goal", "in collision: every point within the tolerance lies inside B"},
    {"goal_tip_out_of_reach", "goal.tip", "out of reach: 3 away from the base, but the chain to link 2 is 2 long"},
    {"goal_tip_path_and_tip", "goal.tip_path", "unknown key"},
    {"goal_tip_path_empty", "goal.tip_path", "must be a list of 1 to 10000 entries, not a list of 0"},
    {"goal_tip_path_inside_obstacle", "goal.tip_path[1]",
     "in collision: every point within the tolerance lies inside B"},
    {"goal_tip_path_near_obstacle", "goal.tip_path[1]", "in collision: a link of radius 0.2 that ends there touches B"},
    {"goal_tip_path_not_finite", "goal.tip_path[1][2]", "must be finite, not '.nan'"},
    {"goal_tip_path_out_of_reach", "goal.tip_path[2]",
     "out of reach: 3 away from the base, but the chain to link 2 is 2 long"},
    {"goal_tip_path_tolerance_missing", "goal.tolerance", "is missing"},
    {"goal_tolerance_missing", "goal.tolerance", "is missing"},
    {"goal_without_state", "goal", "must have joints, tip or tip_path"},
    {"joints_unknown", "robot.joints", "must be universal or dh, not 'dhh'; did you mean 'dh'?"},
    {"key_of_the_other_joints", "robot.links[1].a", "unknown key"},
    {"length_zero", "robot.links[1].length", "must be positive (at least 1e-09), not '0'"},
    {"limits_on_universal", "robot.limits", "unknown key"},
    {"links_missing", "robot.links", "is missing"},
    {"max_link_angle_on_dh", "robot.max_link_angle", "unknown key"},
    {"max_link_angle_right", "robot.max_link_angle", "must be more than 0 and less than a right angle, not '90 deg'"},
    {"max_link_angle_zero", "robot.max_link_angle", "must be more than 0 and less than a right angle, not '0'"},
    {"mesh_crosses_itself", "obstacles[0].file",
     "the surface crosses itself; its inside is not defined (`solid: false` takes the surface alone)"},
    {"mesh_empty", "obstacles[0].file", "'../meshes/empty.obj' is not an OBJ file"},
    {"mesh_face_flat", "obstacles[0].file", "without area: three of its corners lie on a line"},
    {"mesh_face_not_convex", "obstacles[0].file",
     "'../meshes/arrow.obj' has a face (number 1) that is not convex; divide it into triangles"},
    {"mesh_file_missing", "obstacles[0].file", "is missing"},
    {"mesh_huge_promise", "obstacles[0].file", "'../meshes/promise.off' is not an OFF file"},
    {"mesh_in_braces", "", "a file that names a mesh must not be a mapping in braces"},
    {"mesh_index_out_of_range", "obstacles[0].file", "has a face (number 1) with a point that is not in the file"},
    {"mesh_kept_missing", "obstacles[0].file", "'part.obj' is not among `files`"},
    {"mesh_no_such_file", "obstacles[0].file", "'nowhere.obj': there is no such file"},
    {"mesh_not_a_mesh", "obstacles[0].file", "'../meshes/not_a_mesh.off' is not an OFF file"},
    {"mesh_not_closed", "obstacles[0].solid",
     "the surface is not closed: the edge from (0, 0, 1) to (0, 1, 1) has 1 triangle, not 2"},
    {"mesh_not_finite", "obstacles[0].file", "with a coordinate that is not finite"},
    {"mesh_other_format", "obstacles[0].file", "must be the name of a file .obj, .off or .stl, not 'part.ply'"},
    {"mesh_scale_zero", "obstacles[0].scale", "must be positive (at least 1e-09), not '0'"},
    {"mesh_touches_itself", "obstacles[0].file",
     "the surface touches itself in a point or has only one side; its inside is not defined (`solid: false` takes the "
     "surface alone)"},
    {"obstacle_in_plane", "obstacles[0].kind",
     "must be sphere or capsule or cylinder or box or prism or mesh, not 'circle'"},
    {"obstacle_name_twice", "obstacles[1].name", "the name 'B' is already that of the obstacle in line 7"},
    {"prism_axis_missing", "obstacles[0].axis", "is missing"},
    {"prism_crosses_itself", "obstacles[0].vertices",
     "the polygon must be simple, but its edges cross or touch each other"},
    {"prism_flat", "obstacles[0].vertices", "the polygon has no area"},
    {"prism_length_zero", "obstacles[0].length", "must be positive (at least 1e-09), not '0'"},
    {"prism_not_convex", "obstacles[0].vertices", "the polygon must be convex"},
    {"prism_radius", "obstacles[0].radius", "unknown key"},
    {"prism_two_vertices", "obstacles[0].vertices", "must be a list of 3 to 1000 entries, not a list of 2"},
    {"prism_vertex_in_space", "obstacles[0].vertices[1]", "must be a list of 2 entries, not a list of 3"},
    {"radius_negative", "robot.radius", "must not be negative, but is -1"},
    {"rotation_on_universal", "robot.base.rotation", "unknown key"},
    {"self_collision_word", "robot.self_collision", "must be true or false, not 'always'"},
    {"slide_axis_zero", "robot.base.slide.axis", "must not be a zero vector"},
    {"slide_limits_reversed", "robot.base.slide.limits", "the lower end 1 must be less than the upper end -1"},
    {"slide_on_dh", "robot.base.slide", "unknown key"},
    {"sphere_center_in_plane", "obstacles[0].center", "must be a list of 3 entries, not a list of 2"},
    {"sphere_radius_zero", "obstacles[0].radius", "must be positive (at least 1e-09), not '0'"},
    {"start_angles", "start.angles", "unknown key"},
    {"start_bends_backwards", "start.joints[0]", "link 1 is bent by more than max_link_angle, 1.0472"},
    {"start_bends_too_much", "start.joints[0]", "link 1 is bent by more than max_link_angle, 1.0472"},
    {"start_dimension", "start.joints", "must have one entry for each of the 2 links, not 1"},
    {"start_in_a_prism", "start", "in collision: link 2 touches P"},
    {"start_in_collision", "start", "in collision: link 2 touches S"},
    {"start_in_self_collision", "start", "in collision: link 4 touches link 1; link 4 touches link 2"},
    {"start_inside_a_mesh", "start", "in collision: link 1 touches C; link 2 touches C"},
    {"start_joint_not_a_pair", "start.joints[1]", "must be a list of 2 entries, not '0'"},
    {"start_missing", "start", "is missing"},
    {"start_out_of_dh_limits", "start.joints[1]", "the angle 0 of link 2 is out of its limits [1, 2]"},
    {"start_pair_on_dh", "start.joints[1]", "must be an angle (radians, or as in '42.5 deg'), not a list of 2"},
    {"start_slide_missing", "start.slide", "is missing"},
    {"start_slide_out_of_limits", "start.slide", "2 is out of the slide's limits [-1, 1]"},
    {"start_slide_without_slide", "start.slide", "the robot has no sliding base (base: {origin, slide})"},
};

class BadSpatialScenario : public testing::TestWithParam<BadFile>
{
};

TEST_P(BadSpatialScenario, IsRefusedWithPlaceAndReason)
{
    expectRefused(folder, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Files, BadSpatialScenario, testing::ValuesIn(badFiles), nameOf);

TEST(BadSpatialScenarios, AreAllInTheTable)
{
    expectListed(folder, badFiles);
}

TEST(BadSpatialScenarios, FaultsOfOneFileAreReportedTogether)
{
    expectFaultsTogether(
        folder, {"robot.base[2]", "robot.links[0].length", "robot.links[1].parent", "robot.radius",
                 "robot.max_link_angle", "robot.self_collision", "obstacles[0].radius", "obstacles[1].axis",
                 "obstacles[1].length", "obstacles[2].depth", "obstacles[2].max", "obstacles[3].file",
                 "obstacles[4].vertices", "obstacles[4].length", "start.joints", "goal.tolerance",
                 "methods.hppm.repulsion.obstacle 4", "methods.hppm.repulsion.obstacle 5", "methods.hppm.form"});
}

TEST(BadSpatialScenarios, DamagedTextIsReadOrRefusedButNeverCrashes)
{
    for (const char *name : {"spatial_six", "vdsm_obs2"})
    {
        const std::string original =
            contentsOf(NARROWS_SOURCE_DIR "/experiments/scenarios/" + std::string(name) + ".yaml");
        ASSERT_FALSE(original.empty());
        constexpr int rounds = 1000;
        const auto read = [](const std::string &text)
        {
            EXPECT_TRUE(parseScenario(text, "damaged").spatial().model);
        };
        EXPECT_GT(damage(original, "0123456789-.:,[]{}#&*!|>'\"%@`~ \n\tae", rounds, read), rounds / 4) << name;
    }
}

TEST(BadSpatialScenarios, DamagedMeshesAreReadOrRefusedButNeverCrash)
{
    const std::string cube = contentsOf(NARROWS_SOURCE_DIR "/tests/data/meshes/cube.obj");
    ASSERT_FALSE(cube.empty());
    const std::string folderOfMeshes = testing::TempDir();
    constexpr int rounds = 1000;
    const auto read = [&](const std::string &mesh)
    {
        std::ofstream(folderOfMeshes + "damaged.obj") << mesh;
        const Scenario scenario = parseScenario(
            "format: narrows/scenario/1\nname: small\nrobot: {kind: spatial_arm, links: [{length: 1}]}\n"
            "obstacles: [{kind: mesh, file: damaged.obj, position: [9, 9, 9]}]\n"
            "start: {joints: [[0, 0]]}\ngoal: {joints: [[0, 1]]}\n",
            folderOfMeshes + "scenario.yaml");
        EXPECT_TRUE(scenario.spatial().model);
    };
    EXPECT_GT(damage(cube, "0123456789-./ \nvfe", rounds, read), rounds / 4);
}
}  // namespace
}  // namespace narrows
