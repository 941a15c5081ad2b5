// SPDX-License-Identifier: MIT
#include "lumi/mps2/board.h"

#include "lumi/field_format.h"

extern "C" const uint8_t lumi_psram_start[];  // the linker script defines it

namespace lumi::mps2
{
namespace
{

enum class Operation : uint32_t {
    write_string = 0x04,
    command_line = 0x15,
    exit_extended = 0x20,
};

constexpr uint32_t kStoppedApplicationExit = 0x20026;  // ADP_Stopped_ApplicationExit

// The operation is in r0, the address of its parameter block in r1, the result in r0.
int32_t call(Operation operation, const void* parameters)
{
    register uint32_t r0 __asm("r0") = static_cast<uint32_t>(operation);
    register const void* r1 __asm("r1") = parameters;
    __asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return static_cast<int32_t>(r0);
}

uint32_t address(const void* pointer)
{
    return reinterpret_cast<uint32_t>(pointer);
}

uint32_t read_u32(const uint8_t* at)
{
    return at[0] | static_cast<uint32_t>(at[1]) << 8 | static_cast<uint32_t>(at[2]) << 16 |
           static_cast<uint32_t>(at[3]) << 24;
}

}  // namespace

void write(const char* text)
{
    call(Operation::write_string, text);
}

bool command_line(char* buffer, size_t bytes)
{
    const uint32_t block[] = {address(buffer), bytes};
    return call(Operation::command_line, block) == 0;
}

void exit_with(int code)
{
    const uint32_t block[] = {kStoppedApplicationExit, static_cast<uint32_t>(code)};
    for (;;) call(Operation::exit_extended, block);
}

LoadedField loaded_field(uint32_t offset)
{
    const uint8_t* bytes = lumi_psram_start + offset;
    const uint32_t available = kLoadedFieldMemoryBytes - offset;
    const uint32_t stated = read_u32(bytes + detail::format::header::kFileBytesAt);
    return {bytes, stated < available ? stated : available};
}

}  // namespace lumi::mps2
