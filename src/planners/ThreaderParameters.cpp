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
    declareParam<double>("lengthening", this, &Threader::setLengthening, &Threader::getLengthening, "0.:0.1:2.");
    declareParam<double>("square", this, &Threader::setSquare, &Threader::getSquare, "0.:0.05:1.");
    declareParam<double>("narrow", this, &Threader::setNarrow, &Threader::getNarrow, "0.:0.05:1.");
    declareParam<bool>("recentring", this, &Threader::setRecentring, &Threader::getRecentring, "0,1");
    declareParam<std::string>("polish", this, &Threader::setPolish, &Threader::getPolish, "none,length,clearance");
    declareParam<double>("clearance", this, &Threader::setClearance, &Threader::getClearance, "0.:0.001:1.");
    declareParam<int>("rounds", this, &Threader::setRounds, &Threader::getRounds, "1:1:1000");
}

void Threader::setRange(double range)
{
    range_ = within(0.0, range, 100.0, "range");
}

void Threader::setSliceRange(double range)
{
    sliceRange_ = within(0.0, range, 100.0, "slice_range");
}

void Threader::setSliceBox(double box)
{
    sliceBox_ = within(0.1, box, 10.0, "slice_box");
}

void Threader::setSliceDimensions(int dimensions)
{
    sliceDimensions_ = within(1, dimensions, 20, "slice_dimensions");
}

void Threader::setGapWidth(double share)
{
    gapWidth_ = within(0.001, share, 1.0, "gap_width");
}

void Threader::setLengthening(double sizes)
{
    steps_.lengthening = within(0.0, sizes, 2.0, "lengthening");
}

void Threader::setSquare(double share)
{
    steps_.square = within(0.0, share, 1.0, "square");
}

void Threader::setNarrow(double share)
{
    steps_.narrow = within(0.0, share, 1.0, "narrow");
}

void Threader::setPolish(const std::string &aim)
{
    polish_ = oneOf({"none", "length", "clearance"}, aim, "polish");
}

void Threader::setClearance(double share)
{
    clearance_ = within(0.0, share, 1.0, "clearance");
}

void Threader::setRounds(int rounds)
{
    rounds_ = within(1, rounds, 1000, "rounds");
}
}  // namespace narrows
