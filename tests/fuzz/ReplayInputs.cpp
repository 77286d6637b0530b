// SPDX-License-Identifier: BSD-3-Clause
// Gives the files of some folders to a fuzz target, one by one, without libFuzzer: what was ever found stays found.
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "FuzzInput.h"

namespace
{
void feed(const std::filesystem::path &file)
{
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t *>(text.data()), text.size());
}
}  // namespace

int main(int argc, char **argv)
{
    int fed = 0;
    int failed = 0;
    for (int i = 1; i < argc; ++i)
        for (const auto &entry : std::filesystem::directory_iterator(argv[i]))
            try
            {
                if (!entry.is_regular_file())
                    continue;
                ++fed;
                feed(entry.path());
            }
            catch (const std::exception &error)
            {
                ++failed;
                std::cerr << entry.path() << ": " << error.what() << "\n";
            }
    std::cout << fed << " inputs, " << failed << " failed\n";
    return fed > 0 && failed == 0 ? 0 : 1;
}
