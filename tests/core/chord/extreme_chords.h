// SPDX-License-Identifier: MIT
// Valid chord fields at the limits of their format: lattices, rows, texels and palettes, whatever a fuzzer or a seed
// chooses. Every one of them opens and verifies; that they are drawn without harm is for tests to show, and for fuzzers
// (tests/fuzz/extreme_fuzz.cpp).
#pragma once

#include <algorithm>

#include "choices.h"
#include "field_bytes.h"
#include "lumi/detail/lattice.h"

namespace lumi::test
{

// The most bytes of texels. A fuzzer's fields are small: it draws more of them in a second.
#ifdef LUMI_TEST_LIGHT
inline constexpr uint32_t kLargestChord = 1u << 19;  // a board has 4 MB, and a file is copied while it is made
#else
inline constexpr uint32_t kLargestChord = 1u << 21;
#endif
inline constexpr uint32_t kSmallChord = 2048;

class ExtremeChords
{
public:
    ExtremeChords(Choices& choices, uint32_t texel_bytes) : choose_(choices), texel_bytes_(texel_bytes) {}

    Bytes next()
    {
        TestLayout layout;
        layout.texel = static_cast<TexelFormat>(choose_.below(detail::format::kTexelFormats));
        layout.colour_space = static_cast<uint8_t>(choose_.below(detail::format::kColourSpaces));
        choose_.set_bounds(layout.centre, layout.radius);
        set_sizes(layout);
        std::vector<TestSection> sections = {layout_section(layout), texels(layout)};
        if (layout.texel == TexelFormat::palette8 || choose_.once_in(8)) sections.push_back(palette_with_miss());
        return file_of(sections);
    }

private:
    TestSection palette_with_miss()
    {
        Bytes b(4, 0);
        for (uint32_t k = 1; k < detail::format::kPaletteEntries; ++k) {
            const uint8_t coverage = choose_.extreme_byte();
            for (int channel = 0; channel < 3; ++channel) b.push_back(std::min(coverage, choose_.extreme_byte()));
            b.push_back(coverage);
        }
        return {detail::format::kPaletteSection, detail::format::kRequired, b};
    }
    // Lattices of all sizes where something changes, as many of their texels as there is room for.
    void set_sizes(TestLayout& layout)
    {
        const uint32_t sizes[] = {
            1, 2, 5, 63, 64, 65, 65535, 65536, 65537, detail::kMaxLatticeSize, 1 + choose_.below(300)};
        layout.origins = choose_.one_of(sizes);
        layout.directions = choose_.one_of(sizes);
        const uint32_t texel_bytes = detail::format::bytes_per_texel(layout.texel);
        while (layout.directions * texel_bytes > texel_bytes_ / 2) layout.directions /= 2;
        layout.row_stride = layout.directions * texel_bytes + choose_.below(5);
        while (detail::format::is_power_of_two(layout.row_stride)) ++layout.row_stride;
        layout.used_origins = choose_.end_or_any(1, std::min(layout.origins, texel_bytes_ / layout.row_stride));
    }

    TestSection texels(const TestLayout& layout)
    {
        const uint8_t fill = choose_.extreme_byte();
        const bool is_even = choose_.once_in(4);
        return texel_section(layout, [&](uint32_t i, uint32_t k) {
            return is_even ? fill : static_cast<uint8_t>((i * 977 + k + fill) * 0x9E3779B1 >> 24);
        });
    }

    Choices& choose_;
    const uint32_t texel_bytes_;
};

}  // namespace lumi::test
