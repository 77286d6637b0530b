// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ParameterMeanings.h"

#include <map>

namespace narrows
{
namespace
{
using Meanings = std::map<std::string, std::string>;

/// Where a parameter means the same in all planners that have it (OMPL's, except where ours use the name too).
const Meanings &common()
{
    static const Meanings meanings{
        {"algorithm", "NLopt's: slsqp or cobyla (no derivatives)"},
        {"balanced", "grow the two trees in turn"},
        {"bend_gain", "how much the joints are unbent, as a share of a full step"},
        {"border_fraction", "share of expansions from cells at the border of what is explored"},
        {"cache_cc", "remember which motions were found in collision"},
        {"cost_threshold", "states of higher cost are refused"},
        {"degree", "children per node of the tree that finds neighbours"},
        {"delay_collision_checking", "check the cheapest connection first and stop at the first that is free"},
        {"delay_rewiring_to_first_solution", "rewire only when a solution is known"},
        {"dense_delta_fraction", "range of the dense roadmap, as a share of the space's extent"},
        {"drop_unconnected_samples_on_prune", "forget samples without connection whenever the graph is pruned"},
        {"epsilon", "how much longer than the best an answer may be, as a share"},
        {"estimated_dimension", "dimension that neighbours are assumed to spread in"},
        {"extended_fmt", "draw more samples when the first ones gave no solution"},
        {"failed_expansion_score_factor", "what a cell's score is multiplied by when an expansion from it failed"},
        {"find_approximate_solutions", "return the nearest when the goal was not reached"},
        {"focus_search", "keep to states that can still improve the solution"},
        {"frontier_node_ratio", "nodes that refine, per node that explores, at most"},
        {"frontier_threshold", "distance from which on a new node explores"},
        {"goal_bias", "share of samples that are the goal"},
        {"heuristics", "order by cost to the goal too"},
        {"hybridize", "combine the paths of all planners"},
        {"inflation_scaling_parameter", "how fast the inflated heuristic goes back to the true one"},
        {"influence", "distance from which on obstacles repel"},
        {"informed_sampling", "draw only states that can improve the solution"},
        {"init_temperature", "of the test that lets costs rise"},
        {"initial_inflation_factor", "by which the first search overrates what is left to go"},
        {"intermediate_states", "keep states between the ends of a motion as nodes"},
        {"keep_last_valid", "of a motion that is blocked, keep the part before"},
        {"lambda", "damping, as a share of the arm's reach"},
        {"margin", "clearance to keep"},
        {"max_degree", "children per node of that tree, at most"},
        {"max_dist_near", "distance within which the other tree is tried"},
        {"max_failures", "failures in a row to add to the roadmap, after which it is complete"},
        {"max_hybrid_paths", "paths that are combined at most"},
        {"max_iterations", "per waypoint"},
        {"max_nearest_neighbors", "neighbours that a new node is joined to"},
        {"max_pts_per_leaf", "points per leaf of the tree that finds neighbours"},
        {"min_degree", "children per node of that tree, at least"},
        {"min_valid_path_fraction", "share of a blocked motion that must be free for its beginning to be kept"},
        {"nearest_k", "neighbours by number, not by distance"},
        {"new_state_rejection", "refuse new states that cannot improve the solution"},
        {"null_steps", "iterations per waypoint that pose the joints better, at least"},
        {"num_planners", "planners that run side by side"},
        {"num_samples", "states that are drawn before the search begins"},
        {"num_threads", "threads, each with a tree"},
        {"number_sampling_attempts", "draws of an informed sample before giving up"},
        {"obstacle_gain", "how much links keep away from obstacles, as a share of a full step"},
        {"optimality", "end at the first solution, or when no better one is possible"},
        {"ordered_sampling", "draw in batches, the most promising first"},
        {"ordering_batch_size", "samples per batch that is ordered"},
        {"planners", "names of the planners, separated by commas"},
        {"precision", "how near the tip has to come, as a share of the goal's tolerance"},
        {"prune_threshold", "improvement as a share of the cost that makes the tree be pruned"},
        {"prune_threshold_as_fractional_cost_change",
         "improvement as a share of the cost that makes the graph be pruned"},
        {"pruned_measure", "measure pruning by the volume that is left, not by the cost"},
        {"pruning_radius", "distance within which only the cheapest node stays"},
        {"radius_multiplier", "of the neighbourhood, over the least one that converges to the optimum"},
        {"rand_walk_rate", "share of random walks"},
        {"range", "longest motion that is added to a tree, in the space's metric; 0: OMPL chooses by the extent"},
        {"rejection_variant", "which states are refused as useless: 0 none, up to 3"},
        {"rejection_variant_alpha", "how wide that refusal reaches"},
        {"rewire_factor", "of the neighbourhood that is rewired, over the least one that converges to the optimum"},
        {"sample_rejection", "refuse samples that cannot improve the solution"},
        {"samples_per_batch", "states drawn at a time"},
        {"selection_radius", "distance within which the cheapest node is chosen to go on from"},
        {"shortcut", "shorten the paths in between"},
        {"sparse_delta_fraction", "range of the sparse roadmap, as a share of the space's extent"},
        {"step", "distance of two waypoints of the tip"},
        {"stop_on_each_solution_improvement", "return after every improvement"},
        {"stretch_factor", "how much longer ways in the sparse roadmap may be"},
        {"temp_change_factor", "how fast that temperature changes"},
        {"thread_count", "threads that share the trees"},
        {"tree_pruning", "remove nodes that cannot improve the solution"},
        {"truncation_scaling_parameter", "how early a search that is good enough ends"},
        {"update_children", "pass on lower costs to all children at once"},
        {"use_admissible_heuristic", "estimate the way to the goal by one that is never too long"},
        {"use_graph_pruning", "remove states that cannot improve the solution"},
        {"use_just_in_time_sampling", "draw states only when they are needed"},
        {"use_k_nearest", "neighbours by number, not by distance"},
        {"use_projected_distance", "distances in the projection, not in the space"},
        {"use_strict_queue_ordering", "keep the queue in order when costs change"},
    };
    return meanings;
}

const Meanings &ofHppm()
{
    static const Meanings meanings{
        {"direction",
         "of the added function in joint space, one number per joint; rows separated by ;; instead of rows"},
        {"form", "how the paper's curve is followed: in its plane, or all variables (full)"},
        {"goal_candidates", "goals that are drawn if there are many; the nearest is tried most"},
        {"held", "per joint 0, or -1 to hold it where the trace begins, or 1 where it ends"},
        {"held_share", "share of the homotopy over which held joints rest"},
        {"lambda_max", "where a curve that runs past the goal is given up"},
        {"lambda_min", "where a curve that turns back is given up"},
        {"max_deviation", "of the curve from the straight motion, where it is given up"},
        {"max_step", "longest step along the curve; 0: a third of a radian for three joints, growing with their root"},
        {"max_steps", "along a curve; 0: 5000 with search=paper, 200 with restarts"},
        {"orientation", "which way along lambda the curve is followed first: increasing or decreasing"},
        {"points_per_link", "singular points on a link, with poles=points"},
        {"pole_rows", "rows with obstacle functions: dimensions that curves may bend in"},
        {"poles", "points (the paper's), or continuous (the exact distance of link and obstacle)"},
        {"radius", "of the hyperspheres that the paper's curve is followed by, radians"},
        {"repulsion", "strength P: one number, or one per obstacle; rows separated by ;"},
        {"rows", "matrix of the linear part; rows separated by ;, empty for the identity"},
        {"search", "restarts (curves drawn until one arrives), or paper (the one that is given)"},
        {"strength", "factor of the added function, one per row of W"},
        {"traced_from", "start or goal"},
        {"tries", "curves to follow before giving up"},
        {"turns", "full turns added to the goal, one number per joint"},
    };
    return meanings;
}

const Meanings &ofThreader()
{
    static const Meanings meanings{
        {"bending", "push steps that end in an obstacle out of it"},
        {"cells", "take random steps from where the tip has hardly been"},
        {"centring", "go on through the middle of gaps where a step is blocked"},
        {"clearance", "that polish=clearance aims at, as a part of the arm's reach"},
        {"full", "search all of joint space"},
        {"gap_width", "half width of the widest gaps that are threaded, as a part of the arm's reach"},
        {"lengthening", "of links that are led through gaps, at both ends, in sizes of the gap, at most"},
        {"narrow", "share of the centred steps in which only the narrowest gaps count"},
        {"polish", "of the solution: none, length (shorter) or clearance (also away from everything)"},
        {"range", "longest edge in all of joint space, radians; 0: long and short ones by turns"},
        {"recentring", "go to the middle itself where gaps leave nothing of the way"},
        {"rounds", "of all members before giving up; each is half as long again"},
        {"slice_box", "half the side of what is sampled in slices, radians per root of joints and dimensions"},
        {"slice_dimensions", "of the largest slice"},
        {"slice_range", "longest edge in slices, radians; 0: 0.8"},
        {"slices", "search slices of few dimensions through start and goal"},
        {"square", "share of the centred steps in which all links stand square to their gaps"},
        {"straight", "try the straight motions first"},
        {"traces", "follow some of HPPM's curves, from the fifth round on or where trees thread gaps"},
    };
    return meanings;
}

const Meanings &ofVdsm()
{
    static const Meanings meanings{
        {"easing", "rounds of pushing links out of corners"},
        {"margin", "of the danger regions around obstacles; 0: 1.63 radii of the arm"},
        {"margins", "factors of the margin, tried in this order"},
        {"max_jump", "of a joint from one pose to the next; 0: 6 steps"},
        {"mode", "how joints get around obstacles: the paper's two rules, any choice of its points, or a taut string"},
        {"retraction", "of the tip along the slide where it goes around an obstacle"},
        {"side_search", "ways of passing obstacles left or right that are tried per margin, cheapest first"},
        {"step", "distance of two poses along the tip's way; 0: reach / 625"},
    };
    return meanings;
}

const Meanings *own(const std::string &planner)
{
    static const std::map<std::string, const Meanings *> tables{
        {"hppm", &ofHppm()}, {"threader", &ofThreader()}, {"vdsm", &ofVdsm()}};
    const auto found = tables.find(planner);
    return found == tables.end() ? nullptr : found->second;
}
}  // namespace

std::string parameterMeaning(const std::string &planner, const std::string &parameter)
{
    for (const Meanings *meanings : {own(planner), &common()})
    {
        if (meanings == nullptr)
            continue;
        const auto found = meanings->find(parameter);
        if (found != meanings->end())
            return found->second;
    }
    return "";
}
}  // namespace narrows
