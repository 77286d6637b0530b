// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a scenario file: a Scenario or an InputError, never anything else.
#include "FuzzInput.h"
#include "scenario/Scenario.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    try
    {
        narrows::parseScenario(narrows::fuzzText(data, size), NARROWS_SOURCE_DIR "/experiments/scenarios/fuzzed.yaml");
    }
    catch (const narrows::InputError &)
    {
    }
    return 0;
}
