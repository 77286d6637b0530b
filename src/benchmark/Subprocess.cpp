// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Subprocess.h"

#include <array>
#include <cerrno>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace narrows
{
namespace
{
class FileActions
{
public:
    FileActions() { posix_spawn_file_actions_init(&actions_); }
    ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions &) = delete;
    FileActions &operator=(const FileActions &) = delete;

    void silence() { posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0); }
    void sendOutputTo(int pipe) { posix_spawn_file_actions_adddup2(&actions_, pipe, STDOUT_FILENO); }
    const posix_spawn_file_actions_t *get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

/// \return the process, or 0
pid_t spawn(std::vector<std::string> &words, const FileActions &actions)
{
    std::vector<char *> arguments;
    for (std::string &word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    return posix_spawnp(&child, arguments.front(), actions.get(), nullptr, arguments.data(), environ) == 0 ? child : 0;
}

int exitCodeOf(pid_t child)
{
    int status = 0;
    if (child == 0)
        return 127;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return 127;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}
}  // namespace

int runProgram(std::vector<std::string> words, bool silent)
{
    FileActions actions;
    if (silent)
        actions.silence();
    return exitCodeOf(spawn(words, actions));
}

ProgramOutput outputOf(std::vector<std::string> words)
{
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        return {};
    FileActions actions;
    actions.silence();
    actions.sendOutputTo(ends[1]);
    const pid_t child = spawn(words, actions);
    close(ends[1]);
    ProgramOutput output;
    std::array<char, 4096> buffer{};
    for (ssize_t size = 0; (size = read(ends[0], buffer.data(), buffer.size())) != 0;)
    {
        if (size > 0)
            output.text.append(buffer.data(), static_cast<std::size_t>(size));
        else if (errno != EINTR)
            break;
    }
    close(ends[0]);
    output.exitCode = exitCodeOf(child);
    return output;
}
}  // namespace narrows
