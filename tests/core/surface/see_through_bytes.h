// SPDX-License-Identifier: MIT
// Composes files of surface fields with see-through parts, written from surface/format.h.
#pragma once

#include "surface_bytes.h"

namespace lumi::test
{

struct TestGlass {
    std::array<uint8_t, 3> added, passed;
};

using GlassPalette = std::array<TestGlass, 256>;

// Entries of many kinds: clear, tinted, dark; some shine.
inline GlassPalette many_glasses()
{
    GlassPalette palette;
    const auto byte = [](uint32_t k) { return static_cast<uint8_t>(scattered(k)); };
    for (uint32_t k = 0; k < palette.size(); ++k)
        palette[k] = {{byte(6 * k), byte(6 * k + 1), static_cast<uint8_t>(byte(6 * k + 2) / 4)},
                      {byte(6 * k + 3), byte(6 * k + 4), byte(6 * k + 5)}};
    return palette;
}

using detail::format::DrawingOrder;

inline TestSection see_through_section(uint32_t first, const GlassPalette& palette,
                                       DrawingOrder order = DrawingOrder::by_depth)
{
    Bytes b;
    put16(b, first);
    put16(b, static_cast<uint32_t>(order));
    for (const TestGlass& glass : palette) {
        b.insert(b.end(), glass.added.begin(), glass.added.end());
        b.insert(b.end(), glass.passed.begin(), glass.passed.end());
    }
    return {detail::format::kSeeThroughSection, detail::format::kRequired, b};
}

// The patches from `first` on are see-through; opaque ones have no neighbours among them.
inline std::vector<TestSection> see_through_sections(const TestSurface& s, uint32_t first, const GlassPalette& palette,
                                                     DrawingOrder order = DrawingOrder::by_depth)
{
    TestSurface opaque = s;
    opaque.patches.resize(first);
    std::vector<TestSection> sections = surface_sections(s);
    for (TestSection& section : sections) {
        if (section.type != detail::format::kNeighbourSection) continue;
        section = neighbour_section(opaque);
        section.bytes.resize(s.patches.size() * detail::format::kNeighbourBytes, 0xFF);
    }
    sections.push_back(see_through_section(first, palette, order));
    return sections;
}

inline Bytes see_through_file(const TestSurface& s, uint32_t first, const GlassPalette& palette = many_glasses(),
                              DrawingOrder order = DrawingOrder::by_depth)
{
    return file_of(see_through_sections(s, first, palette, order));
}

// Squares that face +z, one texel each, at these heights (Q14) with these entries of their palettes.
struct TestPane {
    int32_t half, z;
    uint8_t texel;
};

inline TestSurface panes(const std::vector<TestPane>& list)
{
    TestSurface s;
    for (const TestPane& pane : list) {
        const auto a = static_cast<uint32_t>(s.vertices.size());
        for (const int32_t y : {-pane.half, pane.half})
            for (const int32_t x : {-pane.half, pane.half}) s.vertices.push_back({x, y, pane.z});
        s.patches.push_back({a, a + 1, a + 2, a + 3, static_cast<uint32_t>(s.texels.size())});
        s.texels.push_back(pane.texel);
    }
    s.texels.resize(s.texels.size() + detail::format::patch_reach(1));
    return s;
}

}  // namespace lumi::test
