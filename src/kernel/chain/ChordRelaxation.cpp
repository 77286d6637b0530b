// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/ChordRelaxation.h"

#include <stdexcept>

#include "kernel/chain/LinkPushes.h"

namespace narrows
{
namespace
{
constexpr double overshoot = 1.2;
constexpr int roundsPerResampling = 10;
constexpr int roundsPerCertificate = 5;
/// A path so many times as long as the chain is coils up and does not come back.
constexpr double coiled = 1.5;
/// Below this cosine between chord and path at its rear end g is about to jump.
constexpr double steep = 0.2;

template <int D>
class Relaxation
{
public:
    using Point = Eigen::Matrix<double, D, 1>;

    Relaxation(const Point &entrance, const ChordObstacles<D> &obstacles, const ChainSpec &spec,
               const RelaxationOptions &options)
      : entrance_(entrance), obstacles_(obstacles), spec_(spec), options_(options)
    {
    }

    RelaxedPath<D> run(const PointPath<D> &nodes, const std::function<bool()> &stop)
    {
        result_.nodes = resampled<D>(nodes, options_.spacing);
        end_ = {nodes.back(), options_.goalRoom};
        const double longest = coiled * spec_.links * spec_.length;
        for (; result_.rounds < options_.rounds && !(stop && stop()); ++result_.rounds)
        {
            if (result_.rounds % roundsPerResampling == 0)
                restart();
            if (lengthOf<D>(result_.nodes) > longest)
                break;
            if (pushAll() && result_.rounds >= nextCertificate_ && certified())
                return result_;
            move();
        }
        certified();
        return result_;
    }

private:
    /// A chord when the obstacles around it were last looked at.
    struct Seen
    {
        Point front;
        Point rear;
        double clearance = -std::numeric_limits<double>::infinity();
    };

    void restart()
    {
        if (result_.rounds > 0)
            result_.nodes = resampled<D>(result_.nodes, options_.spacing);
        seen_.assign(2 * result_.nodes.size(), Seen());
    }

    double room() const { return spec_.radius + options_.margin; }

    bool certified()
    {
        ++result_.certificates;
        const LeaderPath<D> path(result_.nodes, entrance_);
        result_.certificate = certifyChain<D>(path, obstacles_, spec_, options_.certificate);
        result_.chords += result_.certificate.chords;
        nextCertificate_ = result_.rounds + roundsPerCertificate;
        linksMeet_ = linksMeet_ || result_.certificate.failure == ChainFailure::SelfCollision;
        return bool(result_.certificate);
    }

    /// Collects what is asked of the nodes; whether everything looked at is as it must be already.
    bool pushAll()
    {
        const LeaderPath<D> path(result_.nodes, entrance_);
        pushes_.reset(path, options_.goalRoom > 0.0);
        bool good = true;
        for (std::size_t i = 1; i < path.arcs().size(); ++i)
            for (int half = 0; half < 2; ++half)
            {
                const double s = half == 0 ? 0.5 * (path.arcs()[i - 1] + path.arcs()[i]) : path.arcs()[i];
                good = pushChord(path, s, seen_[2 * i + half]) && good;
            }
        // All pairs are looked at only once the certificate has found two that meet.
        if (linksMeet_)
        {
            const double thickness = 2.0 * spec_.radius;
            good = pushLinksApart<D>(path,
                                     {spec_.length, spec_.links * spec_.length, thickness, thickness + options_.margin,
                                      20.0 * options_.margin},
                                     pushes_) &&
                   good;
        }
        return good;
    }

    bool pushChord(const LeaderPath<D> &path, double s, Seen &seen)
    {
        ++result_.chords;
        const Point front = path.at(s);
        const double place = path.follower(s, front, spec_.length);
        const Point rear = path.at(place);
        bool good = unfold(path, place, front, rear);
        good = bend(path, s, place, front, rear) && good;
        if (seen.clearance - std::max((front - seen.front).norm(), (rear - seen.rear).norm()) > room())
            return good;
        const double slack = options_.spacing;
        contacts_.clear();
        obstacles_.contacts(rear, front, room() + slack, contacts_);
        seen = {front, rear, room() + slack};
        for (const ChordContact<D> &contact : contacts_)
        {
            seen.clearance = std::min(seen.clearance, contact.distance);
            if (contact.distance < room())
                pushAway(path, s, place, front, rear, contact);
        }
        return good && seen.clearance >= spec_.radius;
    }

    void pushAway(const LeaderPath<D> &path, double s, double place, const Point &front, const Point &rear,
                  const ChordContact<D> &contact)
    {
        Point normal = contact.normal;
        if (contact.distance < 0.0)
        {
            // Out on the side where the path goes: the chord must not end up on the other one.
            const double f = contact.fraction;
            const Point outward = path.at(place + f * (s - place)) - (rear + f * (front - rear));
            const double width = outward.norm();
            if (width > 0.0 && normal.dot(outward) < steep * width)
                normal = outward / width;
        }
        const double depth = std::min(room() - contact.distance, 20.0 * options_.margin);
        pushes_.pushChord(s, place, contact.fraction, depth * normal, 1.0 + depth);
    }

    /// Where the path behind a link turns away from it, it is straightened.
    bool unfold(const LeaderPath<D> &path, double place, const Point &front, const Point &rear)
    {
        const double cosine = (front - rear).dot(path.directionBefore(place)) / spec_.length;
        if (cosine < steep)
            pushes_.straighten(place);
        return cosine > 0.0;
    }

    /// A joint bent too far goes towards the middle of its neighbours, and they away from it.
    bool bend(const LeaderPath<D> &path, double s, double place, const Point &front, const Point &rear)
    {
        if (!std::isfinite(spec_.maxAngle))
            return true;
        const double behind = path.follower(place, rear, spec_.length);
        const Point inward = 0.5 * (front + path.at(behind)) - rear;
        const double height = inward.norm(), most = spec_.length * std::sin(0.5 * spec_.maxAngle);
        const double excess = height + options_.margin * 0.25 - most;
        if (excess <= 0.0)
            return true;
        const Point pull = excess / (1.5 * height) * inward;
        pushes_.push(place, pull, 1.0);
        pushes_.push(s, -0.5 * pull, 0.5);
        pushes_.push(behind, -0.5 * pull, 0.5);
        return height <= most;
    }

    void move()
    {
        const double share = static_cast<double>(result_.rounds) / options_.rounds;
        pushes_.apply(overshoot, options_.maxMove, options_.smoothing * (1.0 - 0.9 * share), end_, result_.nodes);
    }

    Point entrance_;
    const ChordObstacles<D> &obstacles_;
    const ChainSpec &spec_;
    const RelaxationOptions &options_;
    RelaxedPath<D> result_;
    int nextCertificate_ = 0;
    bool linksMeet_ = false;
    NodePushes<D> pushes_;
    typename NodePushes<D>::End end_{};
    std::vector<Seen> seen_;
    std::vector<ChordContact<D>> contacts_;
};
}  // namespace

RelaxationOptions relaxationOptions(double width)
{
    RelaxationOptions options{};
    options.spacing = 0.1 * width;
    options.margin = 0.0125 * width;
    options.maxMove = 0.0625 * width;
    return options;
}

template <int D>
RelaxedPath<D> relaxChords(const PointPath<D> &nodes, const Eigen::Matrix<double, D, 1> &entrance,
                           const ChordObstacles<D> &obstacles, const ChainSpec &spec, const RelaxationOptions &options,
                           const std::function<bool()> &stop)
{
    if (!(options.spacing > 0.0) || !(options.margin > 0.0) || !(options.maxMove > 0.0) || options.rounds < 1 ||
        !(options.goalRoom >= 0.0) || !(options.smoothing >= 0.0) || options.smoothing > 1.0)
        throw std::invalid_argument("relaxChords: an option is out of range");
    return Relaxation<D>(entrance, obstacles, spec, options).run(nodes, stop);
}

template RelaxedPath<2> relaxChords(const PointPath<2> &, const Eigen::Vector2d &, const ChordObstacles<2> &,
                                    const ChainSpec &, const RelaxationOptions &, const std::function<bool()> &);
template RelaxedPath<3> relaxChords(const PointPath<3> &, const Eigen::Vector3d &, const ChordObstacles<3> &,
                                    const ChainSpec &, const RelaxationOptions &, const std::function<bool()> &);
}  // namespace narrows
