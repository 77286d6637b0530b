// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a database: everything that can be read from one reads it, or throws an InputError.
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "FuzzInput.h"
#include "benchmark/ResultStore.h"

namespace
{
/// A folder for this process's file, gone with it.
class Folder
{
public:
    Folder() : path_(std::filesystem::temp_directory_path() / ("narrows_fuzz" + std::to_string(getpid())))
    {
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder &) = delete;
    Folder &operator=(const Folder &) = delete;

    std::string file() const { return path_ / "fuzzed.db"; }
    void empty() const
    {
        for (const char *suffix : {"", "-wal", "-shm", "-journal"})
            std::filesystem::remove(file() + suffix);
    }

private:
    std::filesystem::path path_;
};

void readAll(const std::string &file)
{
    const narrows::ResultStore store = narrows::ResultStore::open(file);
    store.runs();
    store.examine();
    store.eachPath([](const narrows::PathRow &) {});
    try
    {
        store.run(1);
    }
    catch (const std::invalid_argument &)
    {
    }
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const Folder folder;
    folder.empty();
    std::ofstream(folder.file(), std::ios::binary) << narrows::fuzzText(data, size);
    try
    {
        readAll(folder.file());
    }
    catch (const narrows::InputError &)
    {
    }
    return 0;
}
