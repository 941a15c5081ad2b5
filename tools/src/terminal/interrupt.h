// SPDX-License-Identifier: MIT
// Ctrl-C as a request that long work asks for, so that it can leave cleanly.
#pragma once

#include <atomic>

namespace lumi::tools
{

// From now on the first SIGINT or SIGTERM only sets interrupt_flag(); a second one ends the process at once.
void catch_interrupts();

const std::atomic<bool>& interrupt_flag();

// Throws Interrupted once the flag is set.
void leave_if_interrupted();

}  // namespace lumi::tools
