// SPDX-License-Identifier: MIT
// A line of text built without printf, which would bring in heap and floating point. Text beyond kCapacity is cut off.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace lumi::firmware
{

class TextLine
{
public:
    static constexpr size_t kCapacity = 400;

    TextLine& text(const char* words)
    {
        while (*words != '\0') put(*words++);
        return *this;
    }

    // Writes at least so many digits, with leading zeros.
    TextLine& decimal(uint64_t value, int min_digits = 1)
    {
        constexpr int kMaxDigits = 20;  // 2^64 - 1
        char digits[kMaxDigits];
        int count = 0;
        do {
            digits[count++] = static_cast<char>('0' + value % 10);
            value /= 10;
        } while (value != 0);
        for (int i = count; i < min_digits; ++i) put('0');
        while (count > 0) put(digits[--count]);
        return *this;
    }

    // Writes eight digits, lower case.
    TextLine& hex32(uint32_t value)
    {
        for (int shift = 28; shift >= 0; shift -= 4) put("0123456789abcdef"[(value >> shift) & 15u]);
        return *this;
    }

    const char* c_str() const { return characters_; }

private:
    void put(char c)
    {
        if (length_ == kCapacity) return;
        characters_[length_++] = c;
        characters_[length_] = '\0';
    }

    char characters_[kCapacity + 1] = {};
    size_t length_ = 0;
};

}  // namespace lumi::firmware
