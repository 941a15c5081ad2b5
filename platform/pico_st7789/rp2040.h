// SPDX-License-Identifier: MIT
// Registers of the RP2040 that the example uses, by the names of its datasheet.
#pragma once

#include <stdint.h>

namespace rp2040
{

inline volatile uint32_t& at(uint32_t address)
{
    return *reinterpret_cast<volatile uint32_t*>(address);
}
// The alias of a register whose writes clear bits.
inline void clear_bits(uint32_t address, uint32_t bits)
{
    at(address + 0x3000) = bits;
}

constexpr uint32_t kClocks = 0x40008000, kResets = 0x4000C000, kIoBank0 = 0x40014000, kXosc = 0x40024000,
                   kPllSys = 0x40028000, kUart0 = 0x40034000, kSpi0 = 0x4003C000, kTimer = 0x40054000,
                   kWatchdog = 0x40058000, kDma = 0x50000000, kSio = 0xD0000000;

enum Function : uint32_t { kSpiFunction = 1, kUartFunction = 2, kSioFunction = 5 };
inline void set_function(uint32_t pin, Function function)
{
    at(kIoBank0 + 8 * pin + 4) = function;
}

// Starts the crystal of 12 MHz, 125 MHz for the CPU and the peripherals; a timer of microseconds.
void start_clocks();

inline uint32_t microseconds()
{
    return at(kTimer + 0x28);
}
void wait_microseconds(uint32_t count);

// Writes to a UART of 115,200 baud on pin 0.
void write(const char* text);

}  // namespace rp2040
