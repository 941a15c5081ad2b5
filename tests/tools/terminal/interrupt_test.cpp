// SPDX-License-Identifier: MIT
#include "terminal/failure.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <functional>

#include "support/temporary_folder.h"

namespace lumi::tools
{
namespace
{

struct Ended {
    int code;  // exit code, or 128 + the signal
    std::string err;
};

// Tells what becomes of a process that does this.
Ended in_child(const std::function<void()>& work)
{
    int ends[2] = {};
    REQUIRE(pipe(ends) == 0);
    const pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        for (const int number : {SIGINT, SIGBUS}) signal(number, SIG_DFL);  // Catch's own handlers go
        work();
        _exit(0);
    }
    close(ends[1]);
    int status = 0;
    waitpid(child, &status, 0);
    std::string text(200, '\0');
    text.resize(static_cast<size_t>(std::max<ssize_t>(read(ends[0], text.data(), text.size()), 0)));
    close(ends[0]);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text};
}

}  // namespace

TEST_CASE("an interrupt ends work that leaves nothing behind at once, and is a request to all other work")
{
    const Ended asked = in_child([] {
        catch_interrupts();
        raise(SIGINT);
        _exit(interrupt_flag() ? 7 : 8);
    });
    CHECK(asked.code == 7);
    const Ended at_once = in_child([] {
        catch_interrupts();
        const LeaveAtOnce loading;
        raise(SIGTERM);
    });
    CHECK(at_once.code == kExitInterrupted);
    CHECK(at_once.err == "lumi: interrupted; earlier output is untouched\n");
    const Ended before = in_child([] {
        catch_interrupts();
        raise(SIGINT);
        try {
            const LeaveAtOnce loading;
        } catch (const Interrupted&) {
            _exit(9);
        }
    });
    CHECK(before.code == 9);
    const Ended afterwards = in_child([] {
        catch_interrupts();
        {
            const LeaveAtOnce loading;
        }
        raise(SIGINT);
        _exit(7);
    });
    CHECK(afterwards.code == 7);
}

}  // namespace lumi::tools
