// SPDX-License-Identifier: MIT
// Semihosting: a program on an emulated (or debugged) board talks to its host ("Semihosting for AArch32 and AArch64",
// Arm IHI, T32 interface: BKPT 0xAB). A board without a debugger stops at the first call.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lumi::mps2
{

// Writes a zero-terminated string to the host's console.
void write(const char* text);

// Copies the command line, zero-terminated, into `buffer` of `bytes` bytes; false if it does not fit.
bool command_line(char* buffer, size_t bytes);

// A file of the host, opened for binary writing (an older one is replaced); closed by the destructor.
class OutputFile
{
public:
    explicit OutputFile(const char* path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    // Appends; false after the first failure, also that of opening.
    bool write(const void* bytes, size_t count);
    bool ok() const { return ok_; }

private:
    int32_t handle_;
    bool ok_;
};

// Ends the program; the emulator exits with this code.
[[noreturn]] void exit_with(int code);

}  // namespace lumi::mps2
