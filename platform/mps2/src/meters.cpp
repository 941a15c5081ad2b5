// SPDX-License-Identifier: MIT
#include "lumi/mps2/meters.h"

namespace lumi::mps2
{
namespace
{

// Armv6-M and Armv7-M put SysTick at the same place.
struct SysTick {
    volatile uint32_t control, reload, current;
};

constexpr uint32_t kSysTickAddress = 0xE000E010;
constexpr uint32_t kEnableWithInterruptOnCpuClock = 7;
constexpr uint32_t kReload = 0x00FFFFFF;  // 24 bits, counting down

constexpr uint32_t kPaint = 0xC5C5C5C5;
constexpr uint32_t kPaintedWords = StackMeter::kPaintedBytes / sizeof(uint32_t);

volatile uint32_t wraps = 0;

SysTick& systick()
{
    return *reinterpret_cast<SysTick*>(kSysTickAddress);
}

}  // namespace

void start_instruction_counter()
{
    systick().reload = kReload;
    systick().current = 0;
    systick().control = kEnableWithInterruptOnCpuClock;
    while (systick().current == 0) {  // the first tick loads the counter and is no wrap
    }
}

uint64_t instructions()
{
    uint32_t before, ticks;
    do {
        before = wraps;
        ticks = kReload - systick().current;
        __asm volatile("isb" ::: "memory");  // the reading's own interrupt comes before `wraps` is read again
    } while (before != wraps);
    const uint64_t all = static_cast<uint64_t>(before) * (kReload + 1) + ticks;
    return kInstructionsPer4Ticks % 4 == 0 ? all * (kInstructionsPer4Ticks / 4) : all * kInstructionsPer4Ticks / 4;
}

extern "C" void lumi_systick_handler()
{
    wraps = wraps + 1;
}

// Neither function may call another or be inlined: paint() would overwrite the callee's frame.
__attribute__((noinline)) void StackMeter::paint()
{
    volatile uint32_t* word;
    __asm volatile("mov %0, sp" : "=r"(word));
    top_ = const_cast<uint32_t*>(word);
    for (uint32_t i = 0; i < kPaintedWords; ++i) *--word = kPaint;
}

__attribute__((noinline)) uint32_t StackMeter::high_water_bytes() const
{
    const volatile uint32_t* word = top_ - kPaintedWords;
    while (word != top_ && *word == kPaint) ++word;
    return static_cast<uint32_t>(top_ - word) * sizeof(uint32_t);
}

}  // namespace lumi::mps2
