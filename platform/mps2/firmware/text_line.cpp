// SPDX-License-Identifier: MIT
#include "text_line.h"

namespace lumi::firmware
{
namespace
{

constexpr int kMaxDecimalDigits = 20;  // 2^64 - 1

}  // namespace

void TextLine::put(char c)
{
    if (length_ < kCapacity) {
        characters_[length_++] = c;
        characters_[length_] = '\0';
    }
}

TextLine& TextLine::text(const char* words)
{
    while (*words != '\0') put(*words++);
    return *this;
}

TextLine& TextLine::decimal(uint64_t value)
{
    return decimal(value, 1);
}

TextLine& TextLine::decimal(uint64_t value, int min_digits)
{
    char digits[kMaxDecimalDigits];
    int count = 0;
    do {
        digits[count++] = static_cast<char>('0' + value % 10);
        value /= 10;
    } while (value != 0);
    for (int i = count; i < min_digits; ++i) put('0');
    while (count > 0) put(digits[--count]);
    return *this;
}

TextLine& TextLine::hex32(uint32_t value)
{
    for (int shift = 28; shift >= 0; shift -= 4) put("0123456789abcdef"[(value >> shift) & 15u]);
    return *this;
}

}  // namespace lumi::firmware
