// SPDX-License-Identifier: MIT
// LM3S6965 evaluation board: 50 MHz, an SSD0323 on SSI0 with its data/command pin on C7 and its selection on D0. After
// a frame a line goes to UART0, and the board waits for a byte: who photographs the display sends it.
#include "board.h"

#include "text_line.h"

namespace
{

volatile uint32_t& at(uint32_t address)
{
    return *reinterpret_cast<volatile uint32_t*>(address);
}

constexpr uint32_t kSystem = 0x400FE000, kUart = 0x4000C000, kSsi = 0x40008000, kPortA = 0x40004000,
                   kPortC = 0x40006000, kPortD = 0x40007000, kSysTick = 0xE000E010;
constexpr uint32_t kSysTickReload = 0x00FFFFFF;
// Under QEMU's -icount shift=0 an instruction takes a nanosecond, and a tick 20.
constexpr uint32_t kInstructionsPerTick = 20;

void start_clock()
{
    constexpr uint32_t kInterrupts = kSystem + 0x50, kRcc = kSystem + 0x60, kPllLocked = 1u << 6;
    constexpr uint32_t kDivideBy4 = 3u << 23 | 1u << 22, kBypass = 1u << 11, kPowerDown = 1u << 13,
                       kCrystal8 = 0xEu << 6;
    at(kRcc) = kDivideBy4 | kBypass | kPowerDown | kCrystal8;
    at(kRcc) = kDivideBy4 | kBypass | kCrystal8;
    while ((at(kInterrupts) & kPllLocked) == 0) {
    }
    at(kRcc) = kDivideBy4 | kCrystal8;
    at(kSystem + 0x104) = 1u | 1u << 4;            // RCGC1: UART0, SSI0
    at(kSystem + 0x108) = 1u | 1u << 2 | 1u << 3;  // RCGC2: ports A, C, D
    at(kSysTick + 4) = kSysTickReload;
    at(kSysTick + 8) = 0;
    at(kSysTick) = 5;  // on the CPU's clock
}

uint32_t ticks()
{
    return kSysTickReload - at(kSysTick + 8);
}

void set_pin(uint32_t port, uint32_t pin, bool high)
{
    at(port + (4u << pin)) = high ? 1u << pin : 0u;  // the address selects the pins that are written
}

void put(uint8_t byte)
{
    constexpr uint32_t kRoom = 1u << 1, kReceived = 1u << 2;
    while ((at(kSsi + 0xC) & kRoom) == 0) {
    }
    at(kSsi + 0x8) = byte;
    while ((at(kSsi + 0xC) & kReceived) != 0)  // what the display sends back is nothing
        [[maybe_unused]] const uint32_t nothing = at(kSsi + 0x8);
}

void select(bool data)
{
    constexpr uint32_t kBusy = 1u << 4;
    while ((at(kSsi + 0xC) & kBusy) != 0) {
    }
    set_pin(kPortC, 7, data);
}

void start_display()
{
    at(kPortC + 0x400) = at(kPortC + 0x400) | 1u << 7;  // outputs
    at(kPortD + 0x400) = at(kPortD + 0x400) | 1u;
    at(kPortC + 0x51C) = at(kPortC + 0x51C) | 1u << 7;  // digital
    at(kPortD + 0x51C) = at(kPortD + 0x51C) | 1u;
    at(kPortA + 0x420) = 0x3F;  // UART0 and SSI0 take the pins A0 to A5
    at(kPortA + 0x51C) = 0x3F;
    set_pin(kPortD, 0, true);
    at(kSsi + 0x10) = 10;  // 5 MHz
    at(kSsi) = 7;          // 8 bits a frame
    at(kSsi + 4) = 2;      // on
    select(false);
    constexpr uint8_t kCommands[] = {0x15, 0, 63, 0x75, 0, 63, 0xA4, 0xAF};  // all columns, all rows, normal, on
    for (const uint8_t command : kCommands) put(command);
    select(true);
}

void write(const char* text)
{
    for (; *text != '\0'; ++text) at(kUart) = static_cast<uint8_t>(*text);
}

void wait_for_byte()
{
    constexpr uint32_t kReceiverEmpty = 1u << 4;
    while ((at(kUart + 0x18) & kReceiverEmpty) != 0) {
    }
    [[maybe_unused]] const uint32_t taken = at(kUart);
}

int frame = -1;
uint32_t begin, in_display;

void end_frame()
{
    const uint32_t spent = ((ticks() - begin) & kSysTickReload) - in_display;
    lumi::firmware::TextLine line;
    line.text("frame ").decimal(static_cast<uint32_t>(frame)).text(" instructions ");
    line.decimal(uint64_t{spent} * kInstructionsPerTick).text(" stack ").decimal(used_stack_bytes());
    write(line.text("\n").c_str());
    wait_for_byte();
}

}  // namespace

bool board::next_view(lumi::Orbit& orbit)
{
    if (frame < 0) {
        start_clock();
        start_display();
    } else {
        end_frame();
    }
    if (++frame == kFrames) return false;
    orbit = view_of_frame(frame);
    in_display = 0;
    begin = ticks();
    return true;
}

void board::send(const uint8_t* pixels, uint32_t bytes)
{
    const uint32_t from = ticks();
    for (const uint8_t* const end = pixels + bytes; pixels != end; ++pixels) put(*pixels);
    in_display += (ticks() - from) & kSysTickReload;
}

extern "C" void board_stop(int code)
{
    lumi::firmware::TextLine line;
    write(line.text("exit ").decimal(static_cast<uint32_t>(code)).text("\n").c_str());
    for (;;) {
    }
}
