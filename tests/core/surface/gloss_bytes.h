// SPDX-License-Identifier: MIT
// Composes files of surface fields with gloss maps, written from surface/format.h.
#pragma once

#include <functional>

#include "parts_bytes.h"
#include "states_bytes.h"

namespace lumi::test
{

// A direction of the octahedral map: of the middle of texel (column, row), also of the border's.
inline std::array<double, 3> direction_of_gloss(int column, int row)
{
    constexpr int kSide = static_cast<int>(detail::format::kGlossSide);
    if (column < 0 || column >= kSide) return direction_of_gloss(column < 0 ? 0 : kSide - 1, kSide - 1 - row);
    if (row < 0 || row >= kSide) return direction_of_gloss(kSide - 1 - column, row < 0 ? 0 : kSide - 1);
    double x = (2 * column + 1.0) / kSide - 1, y = (2 * row + 1.0) / kSide - 1;
    const double z = 1 - std::fabs(x) - std::fabs(y);
    if (z < 0) {
        const double u = x;
        x = std::copysign(1 - std::fabs(y), x);
        y = std::copysign(1 - std::fabs(u), y);
    }
    const double length = std::sqrt(x * x + y * y + z * z);
    return {x / length, y / length, z / length};
}

using GlossOf = std::function<double(const std::array<double, 3>&)>;  // 0 .. 255

inline Bytes gloss_map(const GlossOf& texel)
{
    Bytes map;
    constexpr int kSide = static_cast<int>(detail::format::kGlossSide);
    for (int row = -1; row <= kSide; ++row)
        for (int column = -1; column <= kSide; ++column)
            map.push_back(static_cast<uint8_t>(std::lround(texel(direction_of_gloss(column, row)))));
    return map;
}

struct TestGloss {
    std::vector<std::array<uint8_t, 3>> gains;
    std::vector<Bytes> maps;
    std::vector<uint8_t> choices;  // by patch
};

inline TestSection gloss_section(const TestGloss& g)
{
    Bytes b;
    put32(b, static_cast<uint32_t>(g.gains.size()));
    for (const std::array<uint8_t, 3>& gain : g.gains) put32(b, gain[0] + 256u * gain[1] + 65536u * gain[2]);
    for (const Bytes& map : g.maps) b.insert(b.end(), map.begin(), map.end());
    for (size_t k = 0; k < g.choices.size(); k += 4) {
        uint32_t four = 0;
        for (size_t p = k; p < std::min(k + 4, g.choices.size()); ++p) four |= uint32_t{g.choices[p]} << 2 * (p - k);
        b.push_back(static_cast<uint8_t>(four));
    }
    return {detail::format::kGlossSection, detail::format::kRequired, b};
}

// All vertices have tables, and patches have the three maps in turn, or none.
inline TestSurface ball_for_gloss()
{
    TestSurface s = bumpy_ball();
    s.viewed = static_cast<uint32_t>(s.vertices.size());
    return s;
}

inline TestGloss any_gloss(const TestSurface& s)
{
    TestGloss g = {{{30, 40, 50}, {255, 0, 90}, {8, 60, 255}}, {}, {}};
    for (uint32_t k = 0; k < 3; ++k) g.maps.push_back(scattered_bytes(detail::format::kGlossMapBytes, 7 + k));
    for (uint32_t p = 0; p < s.patches.size(); ++p) g.choices.push_back(static_cast<uint8_t>(scattered(p) % 4));
    return g;
}

// Patches of a body have the three maps in turn, or none, where their corners have tables; those of parts have none.
inline TestGloss gloss_of_body(const TestMover& m)
{
    using namespace detail::format;
    const auto number_at = [&](uint32_t at) {
        return m.section[kPartsHeaderBytes + at] + 256u * m.section[kPartsHeaderBytes + at + 1];
    };
    const uint32_t viewed = number_at(part::kFirstViewedAt), patches = number_at(part::kFirstPatchAt);
    TestGloss g = any_gloss(m.all);
    for (uint32_t p = 0; p < m.all.patches.size(); ++p) {
        const TestPatch& patch = m.all.patches[p];
        bool may = p < patches;
        for (const uint32_t corner : {patch.a, patch.b, patch.c, patch.d})
            may = may && (corner < viewed || corner == kNoVertex);
        if (!may) g.choices[p] = 0;
    }
    return g;
}

inline Bytes glossy_file(const TestMover& m, const TestGloss& g)
{
    std::vector<TestSection> sections = mover_sections(m);
    sections.push_back(gloss_section(g));
    return file_of(sections);
}

inline Bytes glossy_file(const TestSurface& s, const TestGloss& g)
{
    std::vector<TestSection> sections = surface_sections(s);
    sections.push_back(gloss_section(g));
    return file_of(sections);
}

}  // namespace lumi::test
