// SPDX-License-Identifier: MIT
// Switches the floating-point unit on before anything else runs: reset leaves it off (Armv7-M, CPACR), and a compiler
// that may use its registers uses them anywhere.
#include <cstdint>

#include "lumi/mps2/board.h"

namespace lumi::mps2
{

extern "C" void lumi_before_constructors()
{
    constexpr uint32_t kCoprocessorAccess = 0xE000ED88;
    constexpr uint32_t kFullAccess = 0xFu << 20;
    volatile uint32_t& access = *reinterpret_cast<volatile uint32_t*>(kCoprocessorAccess);
    access = access | kFullAccess;
    __asm volatile("dsb\n\tisb" ::: "memory");
}

}  // namespace lumi::mps2
