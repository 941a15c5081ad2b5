// SPDX-License-Identifier: MIT
// Core 1 of the RP2040 is started through its boot ROM.
#include "core1.h"

#include "rp2040.h"
#include "text_line.h"

namespace core1
{
namespace
{

using namespace rp2040;

constexpr uint32_t kFifoStatus = kSio + 0x50, kFifoWrite = kSio + 0x54, kFifoRead = kSio + 0x58;
constexpr uint32_t kHasWord = 1u, kHasRoom = 1u << 1;
constexpr uint32_t kVectors = 0xE000ED08;
constexpr uint32_t kStackWords = 1024, kPaint = 0xC5C5C5C5;

using Job = void (*)(int32_t);

alignas(8) uint32_t stack[kStackWords];

void signal()
{
    __asm volatile("sev" ::: "memory");
}

// The core that has read a word sees all that this core wrote before it sent the word.
void fence()
{
    __asm volatile("dmb" ::: "memory");
}

void push(uint32_t word)
{
    fence();
    while ((at(kFifoStatus) & kHasRoom) == 0) {
    }
    at(kFifoWrite) = word;
    signal();
}

uint32_t pop()
{
    while ((at(kFifoStatus) & kHasWord) == 0) __asm volatile("wfe" ::: "memory");
    const uint32_t word = at(kFifoRead);
    fence();
    return word;
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
    for (int word = 0; word < 8 && (at(kFifoStatus) & kHasWord) != 0; ++word)
        [[maybe_unused]] const uint32_t old = at(kFifoRead);
    signal();
}

// The boot ROM of core 1 waits for these words and answers each by the same one; another answer begins anew.
void launch()
{
    const uint32_t words[] = {0, 0, 1, at(kVectors), reinterpret_cast<uint32_t>(stack + kStackWords), address(serve)};
    constexpr uint32_t kWords = sizeof(words) / sizeof(*words);
    for (uint32_t next = 0; next < kWords;) {
        if (words[next] == 0) drain();
        push(words[next]);
        next = pop() == words[next] ? next + 1 : 0;
    }
}

}  // namespace

void start()
{
    for (uint32_t& word : stack) word = kPaint;
    launch();
}

void run(Job job, int32_t argument)
{
    push(reinterpret_cast<uint32_t>(job));
    push(static_cast<uint32_t>(argument));
}

void wait()
{
    [[maybe_unused]] const uint32_t done = pop();
}

}  // namespace core1

void add_report(lumi::firmware::TextLine& line)
{
    uint32_t unused = 0;
    while (unused < core1::kStackWords && core1::stack[unused] == core1::kPaint) ++unused;
    line.text(" core1-stack ").decimal((core1::kStackWords - unused) * sizeof(uint32_t));
}
