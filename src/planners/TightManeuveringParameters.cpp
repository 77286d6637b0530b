// SPDX-License-Identifier: BSD-3-Clause
#include "planners/Require.h"
#include "planners/TightManeuvering.h"

namespace narrows
{
void TightManeuvering::declareParameters()
{
    using Self = TightManeuvering;
    declareParam<std::string>("mode", this, &Self::setMode, &Self::getMode, "relax,middle,beams");
    declareParam<std::string>("field", this, &Self::setField, &Self::getField, "corridor,laplace");
    declareParam<double>("spacing", this, &Self::setSpacing, &Self::getSpacing, "0.:1.:1000.");
    declareParam<int>("corridors", this, &Self::setCorridors, &Self::getCorridors, "1:1:64");
    declareParam<int>("refinements", this, &Self::setRefinements, &Self::getRefinements, "0:1:4");
    declareParam<int>("rounds", this, &Self::setRounds, &Self::getRounds, "1:100:100000");
    declareParam<int>("couples", this, &Self::setCouples, &Self::getCouples, "1:1:4");
}

void TightManeuvering::setMode(const std::string &mode)
{
    oneOf({"relax", "middle", "beams"}, mode, "mode");
    settings_.mode = mode == "relax" ? TightMode::Relax : mode == "middle" ? TightMode::Middle : TightMode::Beams;
}

std::string TightManeuvering::getMode() const
{
    return settings_.mode == TightMode::Relax ? "relax" : settings_.mode == TightMode::Middle ? "middle" : "beams";
}

void TightManeuvering::setField(const std::string &field)
{
    oneOf({"corridor", "laplace"}, field, "field");
    settings_.grid.field = field == "corridor" ? TightField::Corridor : TightField::Laplace;
}

std::string TightManeuvering::getField() const
{
    return settings_.grid.field == TightField::Corridor ? "corridor" : "laplace";
}

void TightManeuvering::setSpacing(double spacing)
{
    settings_.grid.spacing = notNegative(spacing, "spacing");
}

void TightManeuvering::setCorridors(int count)
{
    settings_.grid.corridors = within(1, count, 64, "corridors");
}

void TightManeuvering::setRefinements(int count)
{
    settings_.grid.refinements = within(0, count, 4, "refinements");
}

void TightManeuvering::setRounds(int rounds)
{
    settings_.rounds = within(1, rounds, 100'000, "rounds");
}

void TightManeuvering::setCouples(int couples)
{
    settings_.couples = within(1, couples, 4, "couples");
}
}  // namespace narrows
