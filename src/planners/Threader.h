// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kernel/PlanarModel.h"
#include "kernel/Repulsion.h"
#include "kernel/SpatialModel.h"
#include "kernel/threading/LowDiscrepancy.h"
#include "planners/HPPM.h"
#include "planners/ModelPlanner.h"
#include "planners/ThreadingSearch.h"

namespace narrows
{
/**
   @anchor Threader
   @par Short description
   Two trees that thread gaps: certified bidirectional trees that go through narrow places along the configurations in
   which links cross gaps in the middle, searched in joint space and in nested slices of it, with some homotopy curves
   in between.

   Members, one after the other in rounds that grow: the straight motions; trees in all of joint space; trees in
   slices of 3, 4, ... dimensions through start and goal, spanned by the straight direction and smooth bends of the
   arm, as long as trees that are near each other there come nearer; random steps from where the tip has hardly been
   (TipCells), most of all if no gaps are threaded; curves of HPPM. Trees are kept from one member to the next. The
   whole of joint space is among them, so that the planner is probabilistically complete. The same seed gives the
   same answer.
   @par External documentation
   docs/threader.md

   Parameters: `straight`, `full`, `slices`, `cells`, `traces` switch members on and off, `centring` and `bending` the
   two ways on from a blocked step; `range` longest edge in joint space (0: several lengths in turn); `slice_range`,
   `slice_box`, `slice_dimensions`; `gap_width` widest gap that is threaded, as a part of the arm's reach; `rounds`
   before giving up; `polish` makes the solution shorter (`length`) or keeps it `clearance` away from everything
   (`clearance`): shortcuts (OMPL), then an elastic band (ElasticBand.h). `lengthening`, `square`, `narrow` and
   `recentring` take centred steps apart (ThreadingSearch::Centring).
*/
class Threader : public ModelPlanner
{
public:
    /// \param si of an ArmStateSpace
    /// \param planar, spatial robot and obstacles, where gaps are looked for; that of the other kind of robot is null
    /// \param repulsion makes the poles for the curves, when the first is followed
    Threader(const ob::SpaceInformationPtr &si, std::shared_ptr<const PlanarModel> planar,
             std::shared_ptr<const SpatialModel> spatial,
             std::function<std::shared_ptr<const RepulsionModel>()> repulsion);

    /// Besides OMPL's usual statuses: ABORT when all rounds have been made in vain (reason() is `rounds`) or every
    /// member is switched off (`no_member`), or the space is no ArmStateSpace (`space`). A later call goes on where the
    /// last one stopped.
    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override;
    using ob::Planner::solve;
    void clear() override;                                      ///< Forgets the search, not the parameters.
    void getPlannerData(ob::PlannerData &data) const override;  ///< What has been searched, starts and goals marked.

    ///@{
    /// A parameter: meaning, unit and range are those of params() and the text above.
    /// \throws std::invalid_argument from every setter if the value is out of range.
    void setStraight(bool on) { straight_ = on; }
    bool getStraight() const { return straight_; }
    void setFull(bool on) { full_ = on; }
    bool getFull() const { return full_; }
    void setCells(bool on) { cells_ = on; }
    bool getCells() const { return cells_; }
    void setSlices(bool on) { slices_ = on; }
    bool getSlices() const { return slices_; }
    void setCentring(bool on) { centring_ = on; }
    bool getCentring() const { return centring_; }
    void setBending(bool on) { bending_ = on; }
    bool getBending() const { return bending_; }
    void setTraces(bool on) { traces_ = on; }
    bool getTraces() const { return traces_; }
    void setRange(double range);  ///< longest edge in all of joint space; 0: a sequence of lengths
    double getRange() const { return range_; }
    void setSliceRange(double range);  ///< longest edge in slices; 0: by the number of joints
    double getSliceRange() const { return sliceRange_; }
    void setSliceBox(double box);  ///< half the side of what is sampled in slices, radians per root of joints
    double getSliceBox() const { return sliceBox_; }
    void setSliceDimensions(int dimensions);  ///< of the largest slice
    int getSliceDimensions() const { return sliceDimensions_; }
    void setGapWidth(double share);
    double getGapWidth() const { return gapWidth_; }
    void setLengthening(double sizes);  ///< of links that are threaded, at both ends, at most, in sizes of the gap
    double getLengthening() const { return steps_.lengthening; }
    void setSquare(double share);  ///< of the centred steps: all links square to their gaps
    double getSquare() const { return steps_.square; }
    void setNarrow(double share);  ///< of the centred steps: only the narrowest gaps count
    double getNarrow() const { return steps_.narrow; }
    void setRecentring(bool on) { steps_.recentring = on; }
    bool getRecentring() const { return steps_.recentring; }
    void setPolish(const std::string &aim);  ///< none, length or clearance
    const std::string &getPolish() const { return polish_; }
    void setClearance(double share);  ///< that polishing aims at, as a part of the arm's reach
    double getClearance() const { return clearance_; }
    void setRounds(int rounds);
    int getRounds() const { return rounds_; }
    ///@}

private:
    /// One entry of the schedule.
    struct Member
    {
        enum class Kind
        {
            Full,
            Slice,
            Cells,
            Traces
        };
        Kind kind;
        int dimension = 0;                           ///< of a slice
        std::optional<LowDiscrepancy> samples = {};  ///< of a slice, from its first turn on
    };
    /// What all members of a kind have in common.
    struct Trait
    {
        const char *name;  ///< of the measure solved_by_...
        int share;         ///< samples, in parts of what a round is about
        int windingShare;  ///< the same for eight joints where passages wind, not narrow (ThreadingSearch::isWinding)
        int windingPower;  ///< of the joints, by which that grows
        double range;      ///< longest step, radians
    };
    static const Trait &traitOf(Member::Kind kind);

    void declareParameters();
    /// Null without gaps, or if centred steps are switched off.
    std::unique_ptr<const GapEquations> makeGapEquations() const;
    std::unique_ptr<Overlap> makeOverlap() const;
    /// Plants the trees. False if there is no goal.
    bool begin(const ob::PlannerTerminationCondition &ptc);
    void makeMembers();
    void makeSlices();
    bool goStraight();
    /// One sample of a member. \return whether start and goal are joined
    bool grow(Member &member, const ob::PlannerTerminationCondition &ptc);
    bool growFull(const ob::PlannerTerminationCondition &ptc);
    bool growSlice(Member &member, const ob::PlannerTerminationCondition &ptc);
    bool trace(const ob::PlannerTerminationCondition &ptc);
    /// A member's turn. \return whether start and goal are joined
    bool run(Member &member, const ob::PlannerTerminationCondition &ptc);
    /// To be asked after each sample of a slice's turn, which takes `budget` of them at most: whether the trees are
    /// near each other, but have not come nearer for long, so that slices are not what they need.
    bool isInVain(int budget);
    /// Takes another goal, if there are more, as the goal's tree grows.
    void addGoals();
    /// It is the next member's turn; with the last one's, a round ends.
    void passOn();
    ob::PlannerStatus succeed(const std::string &member, const ob::PlannerTerminationCondition &ptc);
    /// Makes the solution shorter, or keeps it away from everything, as far as time allows.
    void polish(const ob::PlannerTerminationCondition &ptc);
    double reach() const { return planar_ ? planar_->arm.reach() : spatial_->arm.reach(); }
    void measure();
    /// A random point of the unit cube.
    Eigen::VectorXd randomPoint(Eigen::Index dimension);

    std::shared_ptr<const PlanarModel> planar_;
    std::shared_ptr<const SpatialModel> spatial_;
    std::function<std::shared_ptr<const RepulsionModel>()> repulsion_;
    std::shared_ptr<const ArmStateSpace> space_;  ///< null if there is nothing to plan in
    JointChart chart_;

    bool straight_ = true, full_ = true, cells_ = true, slices_ = true, centring_ = true, bending_ = true,
         traces_ = true;
    double range_ = 0.0, sliceRange_ = 0.0, sliceBox_ = 3.0, gapWidth_ = 0.05;
    int sliceDimensions_ = 5, rounds_ = 1000;
    ThreadingSearch::Centring steps_;
    std::string polish_ = "none";
    double clearance_ = 0.02;

    ompl::RNG rng_;
    std::unique_ptr<ThreadingSearch> search_;
    std::vector<Member> members_;
    std::size_t member_ = 0;  ///< whose turn it is
    int round_ = 0, used_ = 0, fullSamples_ = 0;
    int vainSamples_ = 0;  ///< of slices in this round, since the trees last came nearer to each other
    double nearest_ = std::numeric_limits<double>::infinity();  ///< how near that was
    std::shared_ptr<HPPM> curves_;
    int tries_ = 0;
};
}  // namespace narrows
