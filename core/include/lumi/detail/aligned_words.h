// SPDX-License-Identifier: MIT
// Numbers of 16 and 32 bits in memory: low byte first on every machine, in one access. Addresses are divisible by their
// size.
#pragma once

#include <stdint.h>

namespace lumi::detail
{

template <class Word>
constexpr Word low_byte_first(Word v)
{
    static_assert(sizeof(Word) == 2 || sizeof(Word) == 4);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    return sizeof(Word) == 2 ? static_cast<Word>(__builtin_bswap16(static_cast<uint16_t>(v))) : __builtin_bswap32(v);
#else
    return v;
#endif
}

template <class Word>
Word load_aligned(const uint8_t* p)
{
    Word v = 0;
    __builtin_memcpy(&v, __builtin_assume_aligned(p, sizeof v), sizeof v);
    return low_byte_first(v);
}

template <class Word>
void store_aligned(uint8_t* p, Word v)
{
    v = low_byte_first(v);
    __builtin_memcpy(__builtin_assume_aligned(p, sizeof v), &v, sizeof v);
}

}  // namespace lumi::detail
