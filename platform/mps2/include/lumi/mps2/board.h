// SPDX-License-Identifier: MIT
// An emulated board: from reset to main, its host, and fields in its memory.
//
// The start-up code has the vector table's stack pointer and reset handler, .data, .bss, constructors, main and exit. A
// fault prints a line and ends the program with kFaultExitCode, so that a broken test fails and does not hang. A
// program talks to its host by semihosting ("Semihosting for AArch32 and AArch64", Arm IHI, T32 interface: BKPT 0xAB).
// A board without a debugger stops at the first call.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lumi::mps2
{

inline constexpr int kFaultExitCode = 70;

// Called before the first constructor; the default does nothing. A program that uses newlib's files opens them here.
extern "C" void lumi_before_constructors();

// Writes a zero-terminated string to the host's console.
void write(const char* text);

// Copies the command line, zero-terminated, into `buffer` of `bytes` bytes; false if it does not fit.
bool command_line(char* buffer, size_t bytes);

// Ends the program; the emulator exits with this code.
[[noreturn]] void exit_with(int code);

// The emulator's loader (`-device loader,file=F,addr=A,force-raw=on`) puts fields into the board's 16 MB PSRAM, as a
// firmware finds its field in a flash partition of its own.
inline constexpr uint32_t kLoadedFieldMemoryBytes = 16u * 1024 * 1024;

struct LoadedField {
    const uint8_t* bytes;
    size_t size;  // as the file's own header tells, cut off at the end of the memory; open_field decides the rest
};

// Finds the field `offset` bytes into the PSRAM; offset < kLoadedFieldMemoryBytes.
LoadedField loaded_field(uint32_t offset);

}  // namespace lumi::mps2
