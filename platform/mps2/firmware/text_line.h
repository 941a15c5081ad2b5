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

    TextLine& text(const char* words);
    TextLine& decimal(uint64_t value);
    TextLine& decimal(uint64_t value, int min_digits);  // with leading zeros
    TextLine& hex32(uint32_t value);                    // always eight digits, lower case

    const char* c_str() const { return characters_; }

private:
    void put(char c);

    char characters_[kCapacity + 1] = {};
    size_t length_ = 0;
};

}  // namespace lumi::firmware
