// SPDX-License-Identifier: MIT
#include "rp2040.h"

namespace rp2040
{
namespace
{

void wait_for(uint32_t address, uint32_t bits)
{
    while ((at(address) & bits) != bits) {
    }
}

void end_reset(uint32_t blocks)
{
    clear_bits(kResets, blocks);
    wait_for(kResets + 8, blocks);
}

// 12 MHz × 125 / (6 × 2)
void start_pll()
{
    constexpr uint32_t kControl = kPllSys, kPower = kPllSys + 4, kFeedback = kPllSys + 8, kPostDividers = kPllSys + 12;
    constexpr uint32_t kLocked = 1u << 31, kPoweredDown = 1u, kVcoDown = 1u << 5, kPostDown = 1u << 3;
    at(kControl) = 1;
    at(kFeedback) = 125;
    clear_bits(kPower, kPoweredDown | kVcoDown);
    wait_for(kControl, kLocked);
    at(kPostDividers) = 6u << 16 | 2u << 12;
    clear_bits(kPower, kPostDown);
}

}  // namespace

void start_clocks()
{
    constexpr uint32_t kReference = kClocks + 0x30, kSystem = kClocks + 0x3C, kPeripherals = kClocks + 0x48;
    constexpr uint32_t kDma1 = 1u << 2, kIo = 1u << 5, kPads = 1u << 8, kPll = 1u << 12, kSpi = 1u << 16,
                       kTimer1 = 1u << 21, kUart = 1u << 22;
    constexpr uint32_t kStable = 1u << 31, kStartupDelay = 47, kEnable = 0xFABu << 12, kRange12MHz = 0xAA0;
    at(kXosc + 0x0C) = kStartupDelay;
    at(kXosc) = kEnable | kRange12MHz;
    wait_for(kXosc + 4, kStable);
    at(kReference) = 2;  // the crystal
    wait_for(kReference + 8, 1u << 2);
    end_reset(kPll);
    start_pll();
    at(kSystem) = 0;  // from the reference while its other source changes
    wait_for(kSystem + 8, 1u);
    at(kSystem) = 0u << 5 | 1u;  // the PLL
    wait_for(kSystem + 8, 1u << 1);
    at(kPeripherals) = 1u << 11;          // on, from the system's
    at(kWatchdog + 0x2C) = 1u << 9 | 12;  // the timer's microseconds
    end_reset(kDma1 | kIo | kPads | kSpi | kTimer1 | kUart);
    constexpr uint32_t kBaudWhole = 67, kBaudParts = 52;  // 125 MHz / (16 × 115,200)
    at(kUart0 + 0x24) = kBaudWhole;
    at(kUart0 + 0x28) = kBaudParts;
    at(kUart0 + 0x2C) = 3u << 5 | 1u << 4;  // 8 bits, through its buffer
    at(kUart0 + 0x30) = 1u << 8 | 1u;       // sends only
    set_function(0, kUartFunction);
}

void wait_microseconds(uint32_t count)
{
    const uint32_t begin = microseconds();
    while (microseconds() - begin < count) {
    }
}

void write(const char* text)
{
    constexpr uint32_t kFull = 1u << 5;
    for (; *text != '\0'; ++text) {
        while ((at(kUart0 + 0x18) & kFull) != 0) {
        }
        at(kUart0) = static_cast<uint8_t>(*text);
    }
}

}  // namespace rp2040
