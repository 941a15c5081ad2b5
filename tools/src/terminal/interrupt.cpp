// SPDX-License-Identifier: MIT
#include "terminal/interrupt.h"

#include <csignal>

#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

std::atomic<bool> flag{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void on_signal(int)
{
    flag.store(true, std::memory_order_relaxed);
}

}  // namespace

void catch_interrupts()
{
    struct sigaction action = {};
    action.sa_handler = on_signal;
    action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

const std::atomic<bool>& interrupt_flag()
{
    return flag;
}

void leave_if_interrupted()
{
    if (flag.load(std::memory_order_relaxed)) throw Interrupted();
}

}  // namespace lumi::tools
