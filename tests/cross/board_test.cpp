// SPDX-License-Identifier: MIT
// Checks the instruments themselves: the instruction counter across its 24-bit wrap, and the stack meter. Run it with
// COUNT_INSTRUCTIONS. With the argument "unaligned" it reads a word from an odd address instead, which code for an
// ARMv6-M must not survive.
#include <cstring>

#include "lumi/mps2/board.h"
#include "lumi/mps2/meters.h"

namespace
{

using namespace lumi::mps2;

constexpr uint32_t kLoops = 10'000'000 / 4 * kInstructionsPer4Ticks;
constexpr uint64_t kInstructionsPerLoop = 2;
constexpr uint64_t kSlack = 10 * kInstructionsPer4Ticks / 4;  // two readings and a wrap's interrupt
static_assert(kLoops * kInstructionsPerLoop > uint64_t{1 << 24} * kInstructionsPer4Ticks / 4, "the counter must wrap");

constexpr uint32_t kStackBytes = 2000;
constexpr uint32_t kStackSlack = 128;

bool check(bool passed, const char* what)
{
    write(passed ? "passed: " : "FAILED: ");
    write(what);
    write("\n");
    return passed;
}

bool counts_every_instruction()
{
    uint32_t loops = kLoops;
    const uint64_t begin = instructions();
    __asm volatile(".syntax unified\n 1: subs %0, #1\n bne 1b" : "+l"(loops) : : "cc");
    const uint64_t counted = instructions() - begin;
    return counted >= kLoops * kInstructionsPerLoop && counted <= kLoops * kInstructionsPerLoop + kSlack;
}

__attribute__((noinline)) void use_stack()
{
    char bytes[kStackBytes];
    std::memset(bytes, 0, sizeof(bytes));
    __asm volatile("" : : "r"(bytes) : "memory");  // the array must exist
}

bool meters_the_stack()
{
    StackMeter meter;
    meter.paint();
    use_stack();
    const uint32_t used = meter.high_water_bytes();
    return used >= kStackBytes && used <= kStackBytes + kStackSlack;
}

bool survives_an_unaligned_read()
{
    static const char bytes[8] = {};
    uint32_t word;
    __asm volatile("ldr %0, [%1]" : "=l"(word) : "l"(bytes + 1));
    return word == 0;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc == 2 && std::strcmp(argv[1], "unaligned") == 0)
        return check(survives_an_unaligned_read(), "an unaligned read") ? 0 : 1;
    start_instruction_counter();
    const bool counter = check(counts_every_instruction(), "the counter counts every instruction");
    const bool meter = check(meters_the_stack(), "the meter finds the stack's depth");
    return counter && meter ? 0 : 1;
}
