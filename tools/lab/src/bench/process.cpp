// SPDX-License-Identifier: MIT
#include "bench/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "terminal/failure.h"

extern char** environ;

namespace lumi::bench
{
namespace
{

constexpr size_t kShownCharacters = 2000;

// Owns the file actions of a child whose two outputs go to `write_end`.
class ChildFiles
{
public:
    explicit ChildFiles(int write_end)
    {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, write_end, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, write_end, STDERR_FILENO);
    }
    ~ChildFiles() { posix_spawn_file_actions_destroy(&actions_); }
    ChildFiles(const ChildFiles&) = delete;
    ChildFiles& operator=(const ChildFiles&) = delete;

    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_;
};

pid_t start(const std::vector<std::string>& command, int write_end)
{
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    const ChildFiles files(write_end);
    pid_t child = 0;
    const int error = posix_spawnp(&child, arguments[0], files.get(), nullptr, arguments.data(), environ);
    if (error != 0) throw tools::Failure(command[0], std::strerror(error), "install it, or put it into PATH");
    return child;
}

std::string read_all(int descriptor)
{
    std::string text;
    char buffer[4096];
    ssize_t count = 0;
    while ((count = read(descriptor, buffer, sizeof(buffer))) > 0 || (count < 0 && errno == EINTR))
        if (count > 0) text.append(buffer, static_cast<size_t>(count));
    return text;
}

std::string end_of(const std::string& text)
{
    return text.size() <= kShownCharacters ? text : text.substr(text.size() - kShownCharacters);
}

}  // namespace

std::string run_program(const std::vector<std::string>& command)
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw tools::Failure(command[0], std::strerror(errno), "try again");
    pid_t child = 0;
    try {
        child = start(command, ends[1]);
    } catch (...) {
        close(ends[0]);
        close(ends[1]);
        throw;
    }
    close(ends[1]);
    const std::string text = read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return text;
    throw tools::Failure(command[0], "failed", "it said:\n" + end_of(text));
}

}  // namespace lumi::bench
