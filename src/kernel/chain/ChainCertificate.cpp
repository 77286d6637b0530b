// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/ChainCertificate.h"

#include <cmath>
#include <stdexcept>

#include "kernel/chain/ChordWays.h"

namespace narrows
{
namespace
{
void check(const ChainSpec &spec, const CertificateOptions &options)
{
    const bool chain = spec.links >= 1 && spec.length > 0.0 && std::isfinite(spec.length) && spec.radius >= 0.0 &&
                       std::isfinite(spec.radius) && spec.maxAngle > 0.0;
    if (!chain || !(options.resolution > 0.0) || options.maxChords < 1)
        throw std::invalid_argument("certifyChain: a number of the chain or of the options is out of range");
}

template <int D>
class Certifier
{
public:
    using Stretch = ChordStretch<D>;

    Certifier(const LeaderPath<D> &path, const ChordObstacles<D> &obstacles, const ChainSpec &spec,
              const CertificateOptions &options)
      : path_(path), obstacles_(obstacles), spec_(spec), options_(options)
    {
        result_.clearance = std::numeric_limits<double>::infinity();
    }

    ChainCertificate run()
    {
        if (reachesBack() && waitsFree())
            for (std::size_t i = 1; i < path_.arcs().size() && result_; ++i)
                certifySegment(path_.arcs()[i - 1], path_.arcs()[i]);
        if (result_ && spec_.selfCollision)
            keepLinksApart();
        result_.amplification = amplification();
        return result_;
    }

private:
    void fail(ChainFailure failure, double place)
    {
        result_.failure = failure;
        result_.place = place;
    }

    bool reachesBack()
    {
        const double base = jointPlaces<D>(path_, path_.length(), spec_.length, spec_.links).back();
        if (base > 0.0)
            fail(ChainFailure::TooShort, path_.length());
        return result_.failure == ChainFailure::None;
    }

    double waitingLength() const { return spec_.links * spec_.length; }

    /// The chain on the entrance line, before it moves.
    bool waitsFree()
    {
        keepAway(path_.at(-waitingLength()), path_.at(0.0), spec_.radius);
        if (result_.clearance < spec_.radius)
            fail(ChainFailure::ChordClearance, 0.0);
        return result_.failure == ChainFailure::None;
    }

    double keepAway(const typename Stretch::Point &a, const typename Stretch::Point &b, double needed)
    {
        ++result_.chords;
        const double clearance = obstacles_.clearance(a, b, std::max(result_.clearance, needed));
        result_.clearance = std::min(result_.clearance, clearance);
        return clearance;
    }

    /// Halves a segment of the path, the earlier half first, until every stretch is decided.
    void certifySegment(double begin, double end)
    {
        std::vector<double> ends{end};
        while (!ends.empty() && result_)
        {
            const Stretch stretch = chordStretch<D>(path_, spec_.length, begin, ends.back());
            if (isFree(stretch))
            {
                stretches_.push_back(stretch);
                begin = ends.back();
                ends.pop_back();
            }
            else
                ends.push_back(stretch.middle());
            if (result_ && result_.chords >= options_.maxChords && !ends.empty())
                fail(ChainFailure::Unresolved, begin);
        }
    }

    /// Whether all is well over a stretch. If it is so certainly not, or the stretch is too short to be halved, the
    /// result says why.
    bool isFree(const Stretch &stretch)
    {
        const double needed = spec_.radius + stretch.moves();
        const double clearance = keepAway(stretch.rear, stretch.front, needed);
        result_.largestAngle = std::max(result_.largestAngle, stretch.angle);
        const bool last = stretch.half() <= options_.resolution * spec_.length;
        const bool still = stretch.moves() <= 0.25 * spec_.length;  // else what is known of the joints is not
        if (clearance < spec_.radius || (last && clearance < needed && stretch.continuous))
            fail(ChainFailure::ChordClearance, stretch.middle());
        else if (stretch.angle > spec_.maxAngle ||
                 (last && still && stretch.continuous && stretch.angle + stretch.angleMoves > spec_.maxAngle))
            fail(ChainFailure::JointLimit, stretch.place);
        else if (last && !(still && stretch.continuous))
            fail(ChainFailure::Jump, stretch.middle());
        return result_ && still && stretch.continuous && clearance >= needed &&
               stretch.angle + stretch.angleMoves <= spec_.maxAngle;
    }

    void keepLinksApart()
    {
        const double shortest = 2.0 * options_.resolution * spec_.length;
        if (const auto place = findMeetingChords<D>(path_, spec_.length, stretches_, path_.at(-waitingLength()),
                                                    2.0 * spec_.radius, shortest))
            fail(ChainFailure::SelfCollision, *place);
    }

    /// The greatest product of rates g' along the joints behind a place, read off where the chords are.
    double amplification() const
    {
        std::vector<double> most;
        double greatest = 1.0;
        for (const Stretch &stretch : stretches_)
        {
            const auto behind = std::lower_bound(stretches_.begin(), stretches_.begin() + most.size(), stretch.place,
                                                 [](const Stretch &other, double place) { return other.end < place; });
            const std::size_t index = behind - stretches_.begin();
            const double further = stretch.place > 0.0 && index < most.size() ? std::max(most[index], 1.0) : 1.0;
            most.push_back(stretch.rate * further);
            greatest = std::max(greatest, most.back());
        }
        return greatest;
    }

    const LeaderPath<D> &path_;
    const ChordObstacles<D> &obstacles_;
    const ChainSpec &spec_;
    const CertificateOptions &options_;
    ChainCertificate result_;
    std::vector<Stretch> stretches_;
};
}  // namespace

std::string toText(ChainFailure failure)
{
    switch (failure)
    {
        case ChainFailure::None:
            return "";
        case ChainFailure::TooShort:
            return "too_short";
        case ChainFailure::Jump:
            return "jump";
        case ChainFailure::ChordClearance:
            return "chord_clearance";
        case ChainFailure::JointLimit:
            return "joint_limit";
        case ChainFailure::SelfCollision:
            return "self_collision";
        case ChainFailure::Unresolved:
            return "unresolved";
    }
    return "";
}

template <int D>
ChainCertificate certifyChain(const LeaderPath<D> &path, const ChordObstacles<D> &obstacles, const ChainSpec &spec,
                              const CertificateOptions &options)
{
    check(spec, options);
    return Certifier<D>(path, obstacles, spec, options).run();
}

template ChainCertificate certifyChain(const LeaderPath<2> &, const ChordObstacles<2> &, const ChainSpec &,
                                       const CertificateOptions &);
template ChainCertificate certifyChain(const LeaderPath<3> &, const ChordObstacles<3> &, const ChainSpec &,
                                       const CertificateOptions &);
}  // namespace narrows
