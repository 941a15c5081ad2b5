// SPDX-License-Identifier: MIT
#include "support/program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <stdexcept>
#include <thread>

#include "support/temporary_folder.h"

namespace lumi::tools::test
{

namespace
{

pid_t start(const Arguments& arguments, const std::string& out, const std::string& err)
{
    std::vector<char*> pointers;
    for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    constexpr int kPrivate = 0600, kNoSuchProgram = 127;
    dup2(open(out.c_str(), O_WRONLY | O_CREAT, kPrivate), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT, kPrivate), STDERR_FILENO);
    execvp(pointers[0], pointers.data());
    _exit(kNoSuchProgram);
}

Outcome run(const Arguments& arguments, const std::function<void(pid_t, const std::string& err)>& meanwhile)
{
    const TemporaryFolder folder;
    const std::string out = folder / "out", err = folder / "err";
    const pid_t child = start(arguments, out, err);
    if (child < 0) throw std::runtime_error("cannot start " + arguments[0]);
    meanwhile(child, err);
    int status = 0;
    waitpid(child, &status, 0);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, content_of(out), content_of(err)};
}

Arguments with_program(Arguments arguments)
{
    arguments.insert(arguments.begin(), LUMI_PROGRAM);
    return arguments;
}

// A warning may come before the work begins.
void wait_for_progress(const std::string& path)
{
    constexpr auto kPause = std::chrono::milliseconds(20);
    constexpr int kPatience = 1500;  // 30 s
    for (int i = 0; i < kPatience && content_of(path).find(" %") == std::string::npos; ++i)
        std::this_thread::sleep_for(kPause);
}

}  // namespace

Outcome run_program(const Arguments& arguments)
{
    return run(
        arguments, [](pid_t, const std::string&) {});
}

Outcome lumi(Arguments arguments)
{
    return run_program(with_program(std::move(arguments)));
}

Outcome lumi_interrupted(Arguments arguments)
{
    return run(
        with_program(std::move(arguments)),
        [](pid_t child, const std::string& err) {
            wait_for_progress(err);
            kill(child, SIGINT);
        });
}

}  // namespace lumi::tools::test
