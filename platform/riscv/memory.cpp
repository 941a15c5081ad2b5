// SPDX-License-Identifier: MIT
// GCC calls these even in freestanding programs. They are for toolchains that come without a C library.
#include <stddef.h>
#include <stdint.h>

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
