// SPDX-License-Identifier: MIT
#include "virt.h"

#include <stddef.h>

#include "board.h"

using virt::call;
using virt::Operation;

// None of the three instructions is compressed, and they lie in one line of memory.
int32_t virt::call(Operation operation, const void* parameters)
{
    register uint32_t a0 __asm("a0") = static_cast<uint32_t>(operation);
    register const void* a1 __asm("a1") = parameters;
    __asm volatile(
        ".option push\n.option norvc\n.balign 16\n"
        "slli zero, zero, 0x1f\nebreak\nsrai zero, zero, 7\n"
        ".option pop"
        : "+r"(a0)
        : "r"(a1)
        : "memory");
    return static_cast<int32_t>(a0);
}

uint32_t virt::address(const void* pointer)
{
    return reinterpret_cast<uint32_t>(pointer);
}

extern "C" void board_stop(int code)
{
    constexpr uint32_t kStoppedApplicationExit = 0x20026;  // ADP_Stopped_ApplicationExit
    const uint32_t block[] = {kStoppedApplicationExit, static_cast<uint32_t>(code)};
    for (;;) call(Operation::exit_extended, block);
}

// A processor exception ends the program.
extern "C" __attribute__((aligned(4), used)) void board_fault()
{
    call(Operation::write_text, "fault: the program was stopped by a processor exception\n");
    board_stop(70);
}

extern "C" __attribute__((naked, used, section(".lumi_vectors"))) void lumi_reset()
{
    __asm volatile(
        "la sp, lumi_stack_top\n"
        "la t0, board_fault\n"
        "csrw mtvec, t0\n"
        "call lumi_start\n");
}

// GCC calls these even in freestanding programs. They are for toolchains that come without a C library.
extern "C" void* memcpy(void* to, const void* from, size_t count)
{
    uint8_t* out = static_cast<uint8_t*>(to);
    const uint8_t* in = static_cast<const uint8_t*>(from);
    while (count-- > 0) *out++ = *in++;
    return to;
}

extern "C" void* memset(void* to, int value, size_t count)
{
    uint8_t* out = static_cast<uint8_t*>(to);
    while (count-- > 0) *out++ = static_cast<uint8_t>(value);
    return to;
}
