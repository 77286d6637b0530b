// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a file of waypoints, and as the record that a run's process sends.
#include <stdexcept>

#include "FuzzInput.h"
#include "benchmark/PathFile.h"
#include "benchmark/Record.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const narrows::Scenario scenario =
        narrows::readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/gap_small.yaml");
    const std::string text = narrows::fuzzText(data, size);
    try
    {
        narrows::parsePath(text, "fuzzed.json", scenario);
    }
    catch (const narrows::InputError &)
    {
    }
    try
    {
        narrows::recordFromJson(text);
    }
    catch (const std::invalid_argument &)
    {
    }
    return 0;
}
