// SPDX-License-Identifier: MIT
// Ctrl-C as a request that long work asks for, so that it can leave cleanly.
#pragma once

#include <atomic>

namespace lumi::tools
{

// From now on the first SIGINT or SIGTERM only sets interrupt_flag(); a second one ends the process at once.
// What waits to open a pipe fails then.
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
