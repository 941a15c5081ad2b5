// SPDX-License-Identifier: MIT
// How a subcommand ends.
#pragma once

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

}  // namespace lumi::tools
