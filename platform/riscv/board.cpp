// SPDX-License-Identifier: MIT
// QEMU's `virt`. The display is a file on the host for each frame, written over semihosting.
#include "board.h"

#include "start.h"
#include "text_line.h"

namespace
{

using lumi::firmware::TextLine;

enum Operation : uint32_t { kOpen = 0x01, kClose = 0x02, kWriteText = 0x04, kWrite = 0x05, kExitExtended = 0x20 };
constexpr uint32_t kBinaryWrite = 5;                   // fopen's "wb"
constexpr uint32_t kStoppedApplicationExit = 0x20026;  // ADP_Stopped_ApplicationExit

// The three instructions that tell a semihosting call from a breakpoint, none of them compressed.
int32_t call(Operation operation, const void* parameters)
{
    register uint32_t a0 __asm("a0") = operation;
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

uint32_t address(const void* pointer)
{
    return reinterpret_cast<uint32_t>(pointer);
}

// Under -icount shift=0 the counter of cycles counts instructions.
uint64_t instructions()
{
    uint32_t high, low, again;
    do {
        __asm volatile("csrr %0, mcycleh\ncsrr %1, mcycle\ncsrr %2, mcycleh" : "=r"(high), "=r"(low), "=r"(again));
    } while (high != again);
    return static_cast<uint64_t>(high) << 32 | low;
}

int frame = -1;
int32_t file = -1;
uint64_t begin, in_display;

void end_frame()
{
    const uint64_t spent = instructions() - begin - in_display;
    const uint32_t close[] = {static_cast<uint32_t>(file)};
    call(kClose, close);
    TextLine line;
    line.text("frame ").decimal(static_cast<uint32_t>(frame)).text(" instructions ").decimal(spent);
    call(kWriteText, line.text(" stack ").decimal(used_stack_bytes()).text("\n").c_str());
}

}  // namespace

bool board::next_view(lumi::Orbit& orbit)
{
    if (frame >= 0) end_frame();
    if (++frame == kFrames) return false;
    orbit = view_of_frame(frame);
    const char name[] = {'f', 'r', 'a', 'm', 'e', '-', static_cast<char>('0' + frame), '.', 'r', 'a', 'w', '\0'};
    const uint32_t open[] = {address(name), kBinaryWrite, sizeof(name) - 1};
    file = call(kOpen, open);
    if (file < 0) board_stop(1);
    in_display = 0;
    begin = instructions();
    return true;
}

void board::send(const uint8_t* pixels, uint32_t bytes)
{
    const uint64_t from = instructions();
    const uint32_t block[] = {static_cast<uint32_t>(file), address(pixels), bytes};
    if (call(kWrite, block) != 0) board_stop(1);  // the result is how many bytes were not written
    in_display += instructions() - from;
}

extern "C" void board_stop(int code)
{
    const uint32_t block[] = {kStoppedApplicationExit, static_cast<uint32_t>(code)};
    for (;;) call(kExitExtended, block);
}

// A processor exception ends the program.
extern "C" __attribute__((aligned(4), used)) void board_fault()
{
    call(kWriteText, "fault: the program was stopped by a processor exception\n");
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
