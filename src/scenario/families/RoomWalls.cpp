// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/families/RoomWalls.h"

#include <algorithm>
#include <array>

namespace narrows
{
namespace
{
/// The solid cut along all planes of its own and of the rooms' sides: blocks that are solid as a whole or free.
template <int D>
class Blocks
{
public:
    using Index = Eigen::Matrix<int, D, 1>;

    Blocks(const std::vector<AxisBox<D>> &rooms, const AxisBox<D> &solid)
    {
        int blocks = 1;
        for (int axis = 0; axis < D; ++axis)
        {
            cuts_[axis] = cutsAlong(axis, rooms, solid);
            counts_[axis] = static_cast<int>(cuts_[axis].size()) - 1;
            strides_[axis] = blocks;
            blocks *= counts_[axis];
        }
        full_.resize(static_cast<std::size_t>(blocks));
        for (int block = 0; block < blocks; ++block)
        {
            const Index at = index(block);
            const AxisBox<D> whole = box(at, Index(at.array() + 1));
            const typename AxisBox<D>::Point center = 0.5 * (whole.lower + whole.upper);
            full_[block] = std::none_of(rooms.begin(), rooms.end(),
                                        [&center](const AxisBox<D> &room) { return room.contains(center); });
        }
    }

    /// Takes away boxes of solid blocks, each from the first solid block on, as long as can be along each axis in turn.
    std::vector<AxisBox<D>> takeAll()
    {
        std::vector<AxisBox<D>> taken;
        for (int block = 0; block < static_cast<int>(full_.size()); ++block)
        {
            if (full_[block] == 0)
                continue;
            const Index begin = index(block);
            Index end = begin.array() + 1;
            for (int axis = 0; axis < D; ++axis)
                while (end[axis] < counts_[axis] && layerIsFull(begin, end, axis))
                    ++end[axis];
            forEach(begin, end,
                    [this](int one)
                    {
                        full_[one] = 0;
                        return true;
                    });
            taken.push_back(box(begin, end));
        }
        return taken;
    }

private:
    static std::vector<double> cutsAlong(int axis, const std::vector<AxisBox<D>> &rooms, const AxisBox<D> &solid)
    {
        std::vector<double> cuts{solid.lower[axis], solid.upper[axis]};
        for (const AxisBox<D> &room : rooms)
            for (const double cut : {room.lower[axis], room.upper[axis]})
                if (cut > solid.lower[axis] && cut < solid.upper[axis])
                    cuts.push_back(cut);
        std::sort(cuts.begin(), cuts.end());
        cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
        return cuts;
    }

    Index index(int block) const
    {
        Index result;
        for (int axis = 0; axis < D; ++axis)
            result[axis] = block / strides_[axis] % counts_[axis];
        return result;
    }

    AxisBox<D> box(const Index &begin, const Index &end) const
    {
        AxisBox<D> result;
        for (int axis = 0; axis < D; ++axis)
        {
            result.lower[axis] = cuts_[axis][begin[axis]];
            result.upper[axis] = cuts_[axis][end[axis]];
        }
        return result;
    }

    /// Of all blocks in a range; stops at the first one that `action` returns false for, and then returns false.
    template <class Action>
    bool forEach(const Index &begin, const Index &end, const Action &action)
    {
        const Index size = end - begin;
        for (int i = 0; i < size.prod(); ++i)
        {
            int block = 0;
            for (int axis = 0, rest = i; axis < D; rest /= size[axis], ++axis)
                block += (begin[axis] + rest % size[axis]) * strides_[axis];
            if (!action(block))
                return false;
        }
        return true;
    }

    /// The next layer along an axis, that is.
    bool layerIsFull(const Index &begin, const Index &end, int axis)
    {
        Index lower = begin, upper = end;
        lower[axis] = end[axis];
        upper[axis] = end[axis] + 1;
        return forEach(lower, upper, [this](int block) { return full_[block] != 0; });
    }

    std::array<std::vector<double>, D> cuts_;
    Index counts_;
    Index strides_;
    std::vector<char> full_;
};
}  // namespace

template <int D>
std::vector<AxisBox<D>> wallsAround(const std::vector<AxisBox<D>> &rooms, const AxisBox<D> &solid)
{
    return Blocks<D>(rooms, solid).takeAll();
}

template std::vector<AxisBox<2>> wallsAround(const std::vector<AxisBox<2>> &, const AxisBox<2> &);
template std::vector<AxisBox<3>> wallsAround(const std::vector<AxisBox<3>> &, const AxisBox<3> &);
}  // namespace narrows
