// SPDX-License-Identifier: BSD-3-Clause

#include "planners/Require.h"
#include "planners/Threader.h"

namespace narrows
{
void Threader::declareParameters()
{
    declareParam<bool>("straight", this, &Threader::setStraight, &Threader::getStraight, "0,1");
    declareParam<bool>("full", this, &Threader::setFull, &Threader::getFull, "0,1");
    declareParam<bool>("cells", this, &Threader::setCells, &Threader::getCells, "0,1");
    declareParam<bool>("slices", this, &Threader::setSlices, &Threader::getSlices, "0,1");
    declareParam<bool>("centring", this, &Threader::setCentring, &Threader::getCentring, "0,1");
    declareParam<bool>("bending", this, &Threader::setBending, &Threader::getBending, "0,1");
    declareParam<bool>("traces", this, &Threader::setTraces, &Threader::getTraces, "0,1");
    declareParam<double>("range", this, &Threader::setRange, &Threader::getRange, "0.:0.01:100.");
    declareParam<double>("slice_range", this, &Threader::setSliceRange, &Threader::getSliceRange, "0.:0.01:100.");
    declareParam<double>("slice_box", this, &Threader::setSliceBox, &Threader::getSliceBox, "0.1:0.1:10.");
    declareParam<int>("slice_dimensions", this, &Threader::setSliceDimensions, &Threader::getSliceDimensions, "1:1:20");
    declareParam<double>("gap_width", this, &Threader::setGapWidth, &Threader::getGapWidth, "0.001:0.001:1.");
    declareParam<int>("rounds", this, &Threader::setRounds, &Threader::getRounds, "1:1:1000");
}

void Threader::setRange(double range)
{
    require(range >= 0.0 && range <= 100.0, "range must lie between 0 and 100");
    range_ = range;
}

void Threader::setSliceRange(double range)
{
    require(range >= 0.0 && range <= 100.0, "slice_range must lie between 0 and 100");
    sliceRange_ = range;
}

void Threader::setSliceBox(double box)
{
    require(box >= 0.1 && box <= 10.0, "slice_box must lie between 0.1 and 10");
    sliceBox_ = box;
}

void Threader::setSliceDimensions(int dimensions)
{
    require(dimensions >= 1 && dimensions <= 20, "slice_dimensions must lie between 1 and 20");
    sliceDimensions_ = dimensions;
}

void Threader::setGapWidth(double share)
{
    require(share >= 0.001 && share <= 1.0, "gap_width must lie between 0.001 and 1");
    gapWidth_ = share;
}

void Threader::setRounds(int rounds)
{
    require(rounds >= 1 && rounds <= 1000, "rounds must lie between 1 and 1000");
    rounds_ = rounds;
}
}  // namespace narrows
