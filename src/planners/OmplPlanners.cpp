// SPDX-License-Identifier: BSD-3-Clause
#include "planners/OmplPlanners.h"

#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/cforest/CForest.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/est/ProjEST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/prm/SPARS.h>
#include <ompl/geometric/planners/prm/SPARStwo.h>
#include <ompl/geometric/planners/rlrt/BiRLRT.h>
#include <ompl/geometric/planners/rlrt/RLRT.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/LBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyLBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTXstatic.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/SORRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/rrt/pRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/sbl/pSBL.h>
#include <ompl/geometric/planners/sst/SST.h>
#include <ompl/geometric/planners/stride/STRIDE.h>
#include <ompl/geometric/planners/xxl/XXL.h>

#include "planners/ArmDecomposition.h"

namespace narrows
{
namespace
{
template <typename P>
PlannerEntry entry(const char *name, const char *summary)
{
    PlannerEntry result;
    result.name = name;
    result.summary = summary;
    result.make = [](const PlannerContext &context)
    {
        return std::make_shared<P>(context.si);
    };
    return result;
}

template <typename P>
PlannerEntry threaded(const char *name, const char *summary)
{
    PlannerEntry result = entry<P>(name, summary);
    result.threaded = true;
    return result;
}

PlannerEntry lazyLbtrrt()
{
    PlannerEntry result = entry<og::LazyLBTRRT>("lazylbtrrt", "LBTRRT that checks motions lazily");
    result.unsupported = [](const PlannerContext &)
    {
        return "aborts the process once a motion from the start is not free (an assertion in OMPL's LPAstarOnGraph.h)";
    };
    return result;
}

PlannerEntry xxl()
{
    PlannerEntry result =
        entry<og::XXL>("xxl", "searches a grid over the tip's position and samples joints within its cells");
    const auto isPlanar = [](const PlannerContext &context)
    {
        return dynamic_cast<const PlanarArmStateSpace *>(context.si->getStateSpace().get()) != nullptr;
    };
    result.make = [isPlanar](const PlannerContext &context)
    {
        og::XXLDecompositionPtr tips;
        if (isPlanar(context))
            tips = std::make_shared<ArmDecomposition<PlanarArmStateSpace>>(context.si);
        else
            tips = std::make_shared<ArmDecomposition<SpatialArmStateSpace>>(context.si);
        return std::make_shared<og::XXL>(context.si, tips);
    };
    result.unsupported = [isPlanar](const PlannerContext &context)
    {
        const auto *space = dynamic_cast<const SpatialArmStateSpace *>(context.si->getStateSpace().get());
        return isPlanar(context) || space != nullptr
                   ? std::string{}
                   : std::string{"needs a decomposition of the workspace; there is one for arms' tips"};
    };
    return result;
}
}  // namespace

std::vector<PlannerEntry> omplPlanners()
{
    return {
        entry<og::RRT>("rrt", "one tree, grown towards random states"),
        entry<og::RRTConnect>("rrtconnect", "two trees that grow greedily towards each other"),
        entry<og::LazyRRT>("lazyrrt", "RRT that checks motions only once a path is found"),
        entry<og::TRRT>("trrt", "RRT that refuses costly states by a temperature"),
        entry<og::BiTRRT>("bitrrt", "two-tree TRRT"),
        threaded<og::pRRT>("prrt", "RRT grown by several threads"),
        entry<og::RRTstar>("rrtstar", "RRT that rewires its tree, asymptotically optimal"),
        entry<og::RRTsharp>("rrtsharp", "RRTXstatic that keeps its whole tree consistent"),
        entry<og::RRTXstatic>("rrtxstatic", "RRT* that passes improvements on through a queue"),
        entry<og::InformedRRTstar>("informedrrtstar", "RRT* that samples where a better path can be"),
        entry<og::SORRTstar>("sorrtstar", "informed RRT* that draws its samples in sorted batches"),
        entry<og::LBTRRT>("lbtrrt", "RRT with lower bounds, near-optimal; takes all the time that it is given"),
        lazyLbtrrt(),
        entry<og::BITstar>("bitstar", "heuristic search over batches of random geometric graphs"),
        entry<og::ABITstar>("abitstar", "BIT* with inflated and truncated search"),
        entry<og::AITstar>("aitstar", "BIT* with a heuristic from a lazy reverse search"),
        threaded<og::CForest>("cforest", "several RRT* trees in threads that share their solutions"),
        threaded<og::PRM>("prm", "roadmap of free states"),
        threaded<og::PRMstar>("prmstar", "PRM with as many neighbours as optimality needs"),
        entry<og::LazyPRM>("lazyprm", "PRM that checks motions only along candidate paths"),
        entry<og::LazyPRMstar>("lazyprmstar", "lazy PRM with as many neighbours as optimality needs"),
        threaded<og::SPARS>("spars", "sparse roadmap spanner"),
        threaded<og::SPARStwo>("sparstwo", "sparse roadmap spanner without the dense graph"),
        entry<og::EST>("est", "one tree that expands where its states are sparse"),
        entry<og::BiEST>("biest", "two-tree EST"),
        entry<og::ProjEST>("projest", "EST with densities counted in a projection"),
        entry<og::KPIECE1>("kpiece1", "one tree that expands at the outer cells of a projection"),
        entry<og::BKPIECE1>("bkpiece1", "two-tree KPIECE"),
        entry<og::LBKPIECE1>("lbkpiece1", "two-tree KPIECE that checks motions lazily"),
        entry<og::SBL>("sbl", "two trees over a projection's grid, motions checked lazily"),
        threaded<og::pSBL>("psbl", "SBL grown by several threads"),
        entry<og::STRIDE>("stride", "EST with densities from a nearest-neighbour tree"),
        entry<og::PDST>("pdst", "tree of path segments over a subdivided projection"),
        entry<og::FMT>("fmt", "fast marching over a fixed batch of samples"),
        entry<og::BFMT>("bfmt", "two-tree FMT"),
        entry<og::SST>("sst", "sparse tree grown by random motions; meets a goal region, never a single goal state"),
        entry<og::RLRT>("rlrt", "tree without a range limit: goes as far as it is free"),
        entry<og::BiRLRT>("birlrt", "two-tree RLRT"),
        xxl(),
        threaded<og::AnytimePathShortening>("anytimepathshortening",
                                            "several planners in threads, their paths shortened and mixed"),
    };
}
}  // namespace narrows
