// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as an experiment file: an Experiment or an InputError, never anything else.
#include "FuzzInput.h"
#include "benchmark/Experiment.h"
#include "benchmark/QuietOmpl.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const narrows::QuietOmpl quiet;  // each planner that is made tells its parameters
    constexpr int mostScenes = 50;   // each is made, and takes milliseconds
    try
    {
        narrows::parseExperiment(narrows::fuzzText(data, size), NARROWS_SOURCE_DIR "/experiments/fuzzed.cfg",
                                 mostScenes);
    }
    catch (const narrows::InputError &)
    {
    }
    return 0;
}
