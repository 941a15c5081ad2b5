// SPDX-License-Identifier: MIT
#include "lumi/mps2/instruction_counter.h"

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
        __asm volatile("isb" ::
                           : "memory");  // an interrupt that the reading caused is taken before `wraps` is read again
    } while (before != wraps);
    const uint64_t all = static_cast<uint64_t>(before) * (kReload + 1) + ticks;
    return kInstructionsPer4Ticks % 4 == 0 ? all * (kInstructionsPer4Ticks / 4) : all * kInstructionsPer4Ticks / 4;
}

extern "C" void lumi_systick_handler()
{
    wraps = wraps + 1;
}

}  // namespace lumi::mps2
