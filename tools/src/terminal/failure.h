// SPDX-License-Identifier: MIT
// These are the ways in which a subcommand ends: done, failed, called wrongly, or interrupted.
#pragma once

#include <atomic>
#include <stdexcept>
#include <string>

namespace lumi::tools
{

// Exit codes, documented in docs/cli.md.
enum ExitCode : int {
    kExitOk = 0,
    kExitFailed = 1,
    kExitUsage = 2,
    kExitInterrupted = 130,  // 128 + SIGINT, as a shell reports it
};

// From here on all work is done and told. What fails while libraries end (TBB allocates when Embree is released, where
// nothing can be caught) no longer makes a failure of it.
void work_is_done();
bool is_work_done();

// Says what went wrong with which file, and how to mend it: "FILE: PROBLEM; MEND".
class Failure : public std::runtime_error
{
public:
    Failure(const std::string& file, const std::string& problem, const std::string& mend)
        : std::runtime_error(file + ": " + problem + "; " + mend)
    {
    }
};

// A call that cannot be meant: the text names the option and what it takes.
class UsageError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

// The user pressed Ctrl-C; whatever stood at the output's place still stands there.
class Interrupted : public std::runtime_error
{
public:
    explicit Interrupted(const std::string& kept = "earlier output is untouched")
        : std::runtime_error("interrupted; " + kept)
    {
    }
};

// Ctrl-C is a request that long work asks for, so that it can leave cleanly. From now on the first SIGINT or SIGTERM
// only sets interrupt_flag(); a second one ends the process at once. What waits to open a pipe fails then.
void catch_interrupts();

const std::atomic<bool>& interrupt_flag();

// Throws Interrupted once the flag is set.
void leave_if_interrupted();

// While one lives, the first signal ends the process with a word and kExitInterrupted: for work that asks nobody and
// that leaves nothing behind, such as loading a scene. Throws Interrupted if the flag is set already.
class LeaveAtOnce
{
public:
    LeaveAtOnce();
    ~LeaveAtOnce();
    LeaveAtOnce(const LeaveAtOnce&) = delete;
    LeaveAtOnce& operator=(const LeaveAtOnce&) = delete;
};

}  // namespace lumi::tools
