// SPDX-License-Identifier: MIT
// Small chord fields made from the byte layout alone (core/field_bytes.h), as texts for files.
#pragma once

#include <string>
#include <vector>

#include "field_bytes.h"

namespace lumi::tools::test
{

struct TestField {
    uint32_t origins = 40, directions = 60, used_origins = 40;
    TexelFormat texel = TexelFormat::rgb888;
};

inline std::string text_of(const std::vector<lumi::test::TestSection>& sections)
{
    const lumi::test::Bytes file = lumi::test::file_of(sections);
    return {file.begin(), file.end()};
}

// Row i is one colour: bytes that repeat with i, none of them zero, so that every ray hits. Entry e of a palette is
// opaque grey of value e.
inline std::vector<lumi::test::TestSection> field_sections(const TestField& field)
{
    lumi::test::TestLayout layout =
        lumi::test::layout_of(field.origins, field.directions, field.texel, field.used_origins);
    layout.colour_space = static_cast<uint8_t>(ColourSpace::srgb);
    std::copy_n(std::vector<float>{1.5f, -2.0f, 0.25f}.begin(), 3, layout.centre);
    layout.radius = 3.5f;
    const auto texel = [](uint32_t i, uint32_t) { return static_cast<uint8_t>(1 + i * 7 % 250); };
    std::vector<lumi::test::TestSection> sections = {lumi::test::layout_section(layout)};
    if (field.texel == TexelFormat::palette8) {
        sections.push_back(lumi::test::palette_section());
        for (size_t k = 0; k < sections.back().bytes.size(); ++k)
            sections.back().bytes[k] = static_cast<uint8_t>(k % 4 == 3 ? 255 : k / 4);
    }
    sections.push_back(lumi::test::texel_section(layout, texel));
    return sections;
}

inline std::string field_bytes(const TestField& field)
{
    return text_of(field_sections(field));
}

}  // namespace lumi::tools::test
