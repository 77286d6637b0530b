// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Drawing.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "benchmark/BuildInfo.h"

namespace narrows
{
namespace
{
/// A file that is gone when this is.
class TemporaryFile
{
public:
    explicit TemporaryFile(const std::string &content)
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "narrows-record-XXXXXX").string();
        const int descriptor = mkstemp(pattern.data());
        if (descriptor < 0)
            throw std::runtime_error("cannot make a temporary file: " + std::string(std::strerror(errno)));
        close(descriptor);
        path_ = pattern;
        std::ofstream(path_) << content;
    }
    ~TemporaryFile()
    {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile &) = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    const std::string &path() const { return path_; }

private:
    std::string path_;
};

std::string findScript()
{
    for (const char *folder : {build::sourceFolder, build::shareFolder})
    {
        const auto script = std::filesystem::path(folder) / "analysis" / "draw.py";
        if (std::filesystem::exists(script))
            return script.string();
    }
    throw std::runtime_error("drawing needs analysis/draw.py, which is neither in the sources nor installed");
}

/// \return the exit code; 127 if the program cannot be started
int run(std::vector<std::string> words)
{
    std::vector<char *> arguments;
    for (std::string &word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    int status = 0;
    if (posix_spawnp(&child, arguments.front(), nullptr, nullptr, arguments.data(), environ) != 0 ||
        waitpid(child, &status, 0) != child)
        return 127;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}
}  // namespace

void drawRecord(const std::string &scenarioFile, const std::string &recordJson, const std::string &outputFile)
{
    const TemporaryFile record(recordJson);
    const int code = run({"/usr/bin/env", "python3", findScript(), scenarioFile, record.path(), outputFile});
    if (code == 127)
        throw std::runtime_error("drawing needs python3, which was not found");
    if (code != 0)
        throw std::runtime_error("drawing failed (see above); it needs python3 with matplotlib, numpy and yaml");
}
}  // namespace narrows
