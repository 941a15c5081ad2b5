// SPDX-License-Identifier: MIT
#include "terminal/failure.h"

#include <unistd.h>
#include <csignal>

namespace lumi::tools
{

namespace
{

bool is_done = false;

}  // namespace

void work_is_done()
{
    is_done = true;
}

bool is_work_done()
{
    return is_done;
}

namespace
{

std::atomic<bool> flag{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

std::atomic<int> leaving_at_once{0};

void on_signal(int)
{
    flag.store(true, std::memory_order_relaxed);
    if (leaving_at_once.load() == 0) return;
    constexpr char kText[] = "lumi: interrupted; earlier output is untouched\n";
    static_cast<void>(!write(STDERR_FILENO, kText, sizeof kText - 1));
    _exit(kExitInterrupted);
}

}  // namespace

void catch_interrupts()
{
    struct sigaction action = {};
    action.sa_handler = on_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND);  // no SA_RESTART: to open a pipe may wait for ever
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    std::signal(SIGXFSZ, SIG_IGN);  // a write beyond `ulimit -f` fails, and its error is told
}

const std::atomic<bool>& interrupt_flag()
{
    return flag;
}

void leave_if_interrupted()
{
    if (flag.load(std::memory_order_relaxed)) throw Interrupted();
}

LeaveAtOnce::LeaveAtOnce()
{
    ++leaving_at_once;  // before the flag is read: a signal in between is not lost
    if (!flag.load()) return;
    --leaving_at_once;
    throw Interrupted();
}

LeaveAtOnce::~LeaveAtOnce()
{
    --leaving_at_once;
}

}  // namespace lumi::tools
