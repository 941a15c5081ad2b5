// SPDX-License-Identifier: MIT
#include "lumi/detail/crc32.h"

namespace lumi::detail
{
namespace
{

struct NibbleTable {
    uint32_t entry[16];
};

constexpr NibbleTable make_table()
{
    NibbleTable t{};
    for (uint32_t n = 0; n < 16; ++n) {
        uint32_t c = n;
        for (int bit = 0; bit < 4; ++bit) c = (c & 1) != 0 ? 0xEDB88320u ^ (c >> 1) : c >> 1;
        t.entry[n] = c;
    }
    return t;
}

constexpr NibbleTable kTable = make_table();

}  // namespace

uint32_t crc32(uint32_t previous, const uint8_t* bytes, size_t size)
{
    uint32_t c = ~previous;
    for (size_t i = 0; i < size; ++i) {
        c ^= bytes[i];
        c = kTable.entry[c & 15] ^ (c >> 4);
        c = kTable.entry[c & 15] ^ (c >> 4);
    }
    return ~c;
}

}  // namespace lumi::detail
