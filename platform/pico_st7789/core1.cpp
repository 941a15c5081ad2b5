// SPDX-License-Identifier: MIT
// Core 1 of the RP2040, started through its boot ROM. Where it does not answer, as in an emulator of one core, core 0
// does its jobs, on core 1's stack, and keeps count of the time that two cores would have saved.
#include "core1.h"

#include "report.h"
#include "rp2040.h"

namespace core1
{
namespace
{

using namespace rp2040;

constexpr uint32_t kFifoStatus = kSio + 0x50, kFifoWrite = kSio + 0x54, kFifoRead = kSio + 0x58;
constexpr uint32_t kHasWord = 1u, kHasRoom = 1u << 1;
constexpr uint32_t kVectors = 0xE000ED08;
constexpr uint32_t kStackWords = 1024, kPaint = 0xC5C5C5C5;
constexpr int kMostTries = 30;

using Job = void (*)(int32_t);

alignas(8) uint32_t stack[kStackWords];
bool is_alone;
uint32_t job_us, job_end_us, saved_us;

void signal()
{
    __asm volatile("sev" ::: "memory");
}

void push(uint32_t word)
{
    while ((at(kFifoStatus) & kHasRoom) == 0) {
    }
    at(kFifoWrite) = word;
    signal();
}

uint32_t pop()
{
    while ((at(kFifoStatus) & kHasWord) == 0) __asm volatile("wfe" ::: "memory");
    return at(kFifoRead);
}

[[noreturn]] void serve()
{
    for (;;) {
        const Job job = reinterpret_cast<Job>(pop());
        job(static_cast<int32_t>(pop()));
        push(0);
    }
}

uint32_t address(void (*function)())
{
    return reinterpret_cast<uint32_t>(function);
}

void drain()
{
    for (int word = 0; word < 8 && (at(kFifoStatus) & kHasWord) != 0; ++word) {
        [[maybe_unused]] const uint32_t old = at(kFifoRead);
    }
    signal();
}

bool is_answered(uint32_t word)
{
    at(kFifoWrite) = word;
    signal();
    for (int wait = 0; wait < 1000; ++wait) {
        if ((at(kFifoStatus) & kHasWord) != 0) return at(kFifoRead) == word;
    }
    return false;
}

// What the boot ROM of core 1 waits for, each word answered by the same one; another answer begins anew.
bool launch()
{
    const uint32_t words[] = {0, 0, 1, at(kVectors), reinterpret_cast<uint32_t>(stack + kStackWords), address(serve)};
    constexpr uint32_t kWords = sizeof(words) / sizeof(*words);
    uint32_t next = 0;
    for (int k = 0; k < kMostTries && next < kWords; ++k) {
        if (words[next] == 0) drain();
        next = is_answered(words[next]) ? next + 1 : 0;
    }
    return next == kWords;
}

// job(argument) on another stack.
__attribute__((naked, noinline)) void call_on(uint32_t*, Job, int32_t)
{
    __asm volatile(
        "push {r4, lr}\n"
        "mov r4, sp\n"
        "mov sp, r0\n"
        "mov r0, r2\n"
        "blx r1\n"
        "mov sp, r4\n"
        "pop {r4, pc}\n");
}

}  // namespace

void start()
{
    for (uint32_t& word : stack) word = kPaint;
    is_alone = !launch();
}

void run(Job job, int32_t argument)
{
    if (!is_alone) {
        push(reinterpret_cast<uint32_t>(job));
        push(static_cast<uint32_t>(argument));
        return;
    }
    const uint32_t begin = microseconds();
    call_on(stack + kStackWords, job, argument);
    job_end_us = microseconds();
    job_us = job_end_us - begin;
}

void wait()
{
    if (!is_alone) {
        [[maybe_unused]] const uint32_t done = pop();
        return;
    }
    const uint32_t beside_us = microseconds() - job_end_us;
    saved_us += beside_us < job_us ? beside_us : job_us;
}

}  // namespace core1

void add_report(lumi::firmware::TextLine& line)
{
    uint32_t unused = 0;
    while (unused < core1::kStackWords && core1::stack[unused] == core1::kPaint) ++unused;
    line.text(" core1-stack ").decimal((core1::kStackWords - unused) * sizeof(uint32_t));
    line.text(" core1 ").text(core1::is_alone ? "modelled" : "runs").text(" saves ").decimal(core1::saved_us);
    core1::saved_us = 0;
}
