// SPDX-License-Identifier: MIT
// QEMU's `virt`. The display is a file on the host for each frame, written over semihosting.
#include "board.h"

#include "text_line.h"
#include "virt.h"

namespace
{

using lumi::firmware::TextLine;
using virt::address;
using virt::call;
using virt::Operation;

constexpr uint32_t kBinaryWrite = 5;  // fopen's "wb"

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
    call(Operation::close, close);
    TextLine line;
    line.text("frame ").decimal(static_cast<uint32_t>(frame)).text(" instructions ").decimal(spent);
    call(Operation::write_text, line.text(" stack ").decimal(used_stack_bytes()).text("\n").c_str());
}

}  // namespace

bool board::next_view(lumi::Orbit& orbit)
{
    if (frame >= 0) end_frame();
    if (++frame == kFrames) return false;
    orbit = view_of_frame(frame);
    const char name[] = {'f', 'r', 'a', 'm', 'e', '-', static_cast<char>('0' + frame), '.', 'r', 'a', 'w', '\0'};
    const uint32_t open[] = {address(name), kBinaryWrite, sizeof(name) - 1};
    file = call(Operation::open, open);
    if (file < 0) board_stop(1);
    in_display = 0;
    begin = instructions();
    return true;
}

void board::send(const uint8_t* pixels, uint32_t bytes)
{
    const uint64_t from = instructions();
    const uint32_t block[] = {static_cast<uint32_t>(file), address(pixels), bytes};
    if (call(Operation::write, block) != 0) board_stop(1);  // the result is how many bytes were not written
    in_display += instructions() - from;
}
