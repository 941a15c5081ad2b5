// SPDX-License-Identifier: MIT
// Numbers that decide what a generator makes: from a seed, or from the bytes of a fuzzer.
#pragma once

#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace lumi::test
{

class Choices
{
public:
    explicit Choices(uint32_t seed) : state_(seed) {}
    // The bytes decide first. What follows when they are used up depends on them, too.
    Choices(const uint8_t* bytes, size_t size) : bytes_(bytes), left_(size), state_(static_cast<uint32_t>(size)) {}

    // 0 .. count - 1.
    uint32_t below(uint32_t count) { return count == 0 ? 0 : word(count > 256) % count; }
    int32_t between(int32_t low, int32_t high)
    {
        const uint32_t from = static_cast<uint32_t>(low), count = static_cast<uint32_t>(high) - from + 1;
        return static_cast<int32_t>(from + below(count));
    }
    bool once_in(uint32_t count) { return below(count) == 0; }
    template <class Value, size_t kCount>
    const Value& one_of(const Value (&values)[kCount])
    {
        return values[below(static_cast<uint32_t>(kCount))];
    }
    template <class Value>
    Value one_of(std::initializer_list<Value> values)
    {
        return values.begin()[below(static_cast<uint32_t>(values.size()))];
    }
    // One of the ends or anything between them.
    uint32_t end_or_any(uint32_t least, uint32_t most)
    {
        const uint32_t ends[] = {least, least < most ? least + 1 : most, most > least ? most - 1 : least, most};
        return below(3) != 0 ? one_of(ends) : least + below(most - least + 1);
    }
    uint8_t extreme_byte()
    {
        constexpr uint8_t kEnds[] = {0, 255, 127, 128};
        const uint32_t choice = below(5);
        return choice < 4 ? kEnds[choice] : byte();
    }
    // The sphere of a field.
    void set_bounds(float (&centre)[3], float& radius)
    {
        for (float& c : centre) c = one_of({0.0f, 1.0f, -FLT_MAX, FLT_MAX, FLT_MIN, FLT_TRUE_MIN});
        radius = one_of({1.0f, FLT_MAX, FLT_MIN, FLT_TRUE_MIN});
    }
    uint8_t byte() { return static_cast<uint8_t>(below(256)); }

private:
    uint32_t word(bool is_wide)
    {
        uint32_t v = 0;
        const uint32_t count = is_wide ? 4 : 1;
        for (uint32_t k = 0; k < count; ++k) v = v << 8 | next_byte();
        return v;
    }
    uint32_t next_byte()
    {
        if (left_ != 0) {
            --left_;
            state_ = state_ * 31 + *bytes_;
            return *bytes_++;
        }
        state_ = state_ * 1664525 + 1013904223;
        return state_ >> 24;
    }

    const uint8_t* bytes_ = nullptr;
    size_t left_ = 0;
    uint32_t state_;
};

}  // namespace lumi::test
