// SPDX-License-Identifier: MIT
#include "drawing.h"

extern "C" uint8_t __heap_base;  // the linker's: where data and stack end

// Compilers call these where they see loops that copy or fill. Built without their knowledge of these loops
// (-fno-builtin), or each would call itself.
extern "C" void* memset(void* to, int value, size_t bytes)
{
    for (size_t k = 0; k < bytes; ++k) static_cast<uint8_t*>(to)[k] = static_cast<uint8_t>(value);
    return to;
}

extern "C" void* memcpy(void* to, const void* from, size_t bytes)
{
    for (size_t k = 0; k < bytes; ++k) static_cast<uint8_t*>(to)[k] = static_cast<const uint8_t*>(from)[k];
    return to;
}

namespace lumi::wasm
{
namespace
{

constexpr size_t kPageBytes = 65536;  // of WebAssembly
uintptr_t end = 0;                    // of what is reserved; 0: nothing is

uintptr_t begin_of_memory()
{
    return (reinterpret_cast<uintptr_t>(&__heap_base) + kAlignment - 1) / kAlignment * kAlignment;
}

bool has_memory_up_to(uint64_t address)
{
    const uint64_t pages = (address + kPageBytes - 1) / kPageBytes, present = __builtin_wasm_memory_size(0);
    constexpr uint64_t kMostPages = 65536;
    if (pages > kMostPages) return false;
    return pages <= present ||
           __builtin_wasm_memory_grow(0, static_cast<size_t>(pages - present)) != static_cast<size_t>(-1);
}

}  // namespace

uint8_t* reserve(size_t bytes)
{
    if (end == 0) end = begin_of_memory();
    const uint64_t next = (uint64_t{end} + bytes + kAlignment - 1) / kAlignment * kAlignment;
    if (next > UINT32_MAX || !has_memory_up_to(next)) return nullptr;
    uint8_t* const region = reinterpret_cast<uint8_t*>(end);
    end = static_cast<uintptr_t>(next);
    return region;
}

void release_from(const uint8_t* region)
{
    end = region == nullptr ? 0 : reinterpret_cast<uintptr_t>(region);
}

}  // namespace lumi::wasm
