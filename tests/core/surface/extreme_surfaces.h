// SPDX-License-Identifier: MIT
// Valid surface fields at the limits of their format: numbers of vertices, patches and texels, sides of textures,
// coordinates and tables, whatever a fuzzer or a seed chooses. Every one of them opens and verifies; that they are
// drawn without harm is for tests to show, and for fuzzers (tests/fuzz/extreme_fuzz.cpp).
#pragma once

#include <algorithm>

#include "choices.h"
#include "surface/gloss_bytes.h"

namespace lumi::test
{

// The most that a field has. A fuzzer's are small: it draws more of them in a second.
struct SurfaceLimits {
    uint32_t vertices, patches, texels;
};
inline constexpr SurfaceLimits kLargestSurface = {detail::format::kMaxSurfaceVertices, detail::format::kMaxPatches,
                                                  1u << 14};
inline constexpr SurfaceLimits kSmallSurface = {12, 10, 4100};

class ExtremeSurfaces
{
public:
    ExtremeSurfaces(Choices& choices, const SurfaceLimits& limits) : choose_(choices), limits_(limits) {}

    Bytes next()
    {
        TestSurface s;
        std::vector<TestSection> sections = sections_of(s);
        if (choose_.below(4) != 0) sections.push_back(choose_.once_in(2) ? neighbour_section(s) : neighbours(s));
        return file_of(sections);
    }

    // Some patches or all of them are see-through.
    Bytes next_see_through()
    {
        TestSurface s;
        std::vector<TestSection> sections = sections_of(s);
        const auto patches = static_cast<uint32_t>(s.patches.size());
        const uint32_t first = choose_.end_or_any(0, patches - 1);
        GlassPalette palette;
        for (TestGlass& glass : palette)
            for (size_t c = 0; c < 3; ++c)
                glass.added[c] = choose_.extreme_byte(), glass.passed[c] = choose_.extreme_byte();
        sections.push_back(see_through_section(first, palette));
        if (choose_.once_in(2)) {
            s.patches.resize(first);
            sections.push_back(neighbours(s));
            sections.back().bytes.resize(patches * detail::format::kNeighbourBytes, 0xFF);
        }
        return file_of(sections);
    }

    // Any numbers may be those of light states.
    Bytes next_with_states()
    {
        TestSurface s;
        std::vector<TestSection> sections = sections_of(s);
        std::vector<TestState> states(2 + choose_.below(3));
        for (TestState& state : states) state = {"x", choose_.end_or_any(16, 255)};
        TestLight light = light_of(s, states);
        for (Bytes* bytes : {&light.palettes, &light.nodes, &light.means, &light.gains})
            for (uint8_t& byte : *bytes) byte = choose_.extreme_byte();
        return file_with_states(sections, light);
    }

    // Opaque patches whose corners have tables may have maps, of any numbers.
    Bytes next_with_gloss()
    {
        TestSurface s;
        std::vector<TestSection> sections = sections_of(s);
        if (s.viewed == 0) return file_of(sections);
        shorten_turns(s, sections.back());
        sections.push_back(neighbours(s));
        TestGloss gloss;
        gloss.gains.resize(1 + choose_.below(detail::format::kMaxGlossMaps));
        for (auto& gain : gloss.gains) {
            for (uint8_t& g : gain) g = choose_.extreme_byte();
            gloss.maps.push_back(scattered_bytes(detail::format::kGlossMapBytes, choose_.extreme_byte()));
            if (choose_.once_in(2)) gloss.maps.back().assign(detail::format::kGlossMapBytes, choose_.extreme_byte());
        }
        for (const TestPatch& p : s.patches) {
            bool may = true;
            for (const uint32_t corner : {p.a, p.b, p.c, p.d})
                may = may && (corner < s.viewed || corner == detail::format::kNoVertex);
            const uint32_t choice = choose_.below(static_cast<uint32_t>(gloss.gains.size()) + 1);
            gloss.choices.push_back(static_cast<uint8_t>(may ? choice : 0));
        }
        sections.push_back(gloss_section(gloss));
        return file_of(sections);
    }

private:
    // Turns to normals, at most as long as a file with gloss may have them: along an axis, none, or any.
    void shorten_turns(const TestSurface& s, TestSection& views)
    {
        const uint32_t first = detail::format::view_colours_bytes(s.code_bits),
                       bytes = detail::format::view_bytes(s.code_bits);
        for (uint32_t v = 0; v < s.viewed; ++v) {
            uint8_t* const turn = &views.bytes[first + v * bytes + detail::format::view_turn_at(s.code_bits)];
            const bool is_axis = choose_.once_in(2);
            for (uint32_t c = 0; c < 3; ++c) turn[c] = is_axis ? 0 : static_cast<uint8_t>(choose_.between(-73, 73));
            if (is_axis && choose_.below(8) != 0) turn[choose_.below(3)] = choose_.once_in(2) ? 127 : 128;
        }
    }

    // All but neighbours.
    std::vector<TestSection> sections_of(TestSurface& s)
    {
        set_counts(s);
        const bool has_both_sides = choose_.below(2) != 0;
        set_other_numbers(s);
        const bool is_walk = choose_.once_in(2);
        if (is_walk)
            walk(s.vertices);
        else
            for (SurfacePoint& v : s.vertices) v = vertex(s);
        const bool has_largest_textures = choose_.below(4) != 0;
        for (TestPatch& p : s.patches) p = patch(s, is_walk, has_largest_textures);
        if (has_both_sides) add_turned_patches(s);
        std::vector<TestSection> sections = {surface_section(s),
                                             vertex_section(s),
                                             patch_section(s),
                                             {detail::format::kColourSection, detail::format::kRequired, s.texels},
                                             palette()};
        if (s.viewed != 0) sections.push_back(views(s));
        return sections;
    }

    // Few, some, or now and then as many as there may be.
    uint32_t mostly_few(uint32_t least, uint32_t most)
    {
        constexpr uint32_t kFew = 24, kSome = 2000;
        if (choose_.once_in(64)) return choose_.end_or_any(least, most);
        return choose_.end_or_any(least, std::min(most, least + (choose_.once_in(2) ? kFew : kSome)));
    }

    void set_counts(TestSurface& s)
    {
        s.vertices.resize(mostly_few(3, limits_.vertices));
        s.patches.resize(mostly_few(1, limits_.patches));
        s.viewed = choose_.once_in(3) ? 0 : choose_.end_or_any(0, static_cast<uint32_t>(s.vertices.size()));
        s.code_bits = choose_.end_or_any(1, detail::format::kMaxCodeBits);
    }

    void set_other_numbers(TestSurface& s)
    {
        s.colour_space = choose_.below(detail::format::kColourSpaces);
        s.longest_edge_q6 = choose_.end_or_any(1, 128);
        choose_.set_bounds(s.centre, s.radius);
        // A texel more than any patch may reach, all that any may, or as few as some do.
        const uint32_t most = detail::format::patch_reach(detail::format::kMaxPatchSide),
                       least = detail::format::patch_reach(1);
        s.texels.resize(choose_.below(3) != 0 ? most + choose_.below(2) : choose_.end_or_any(least, limits_.texels));
        const uint8_t fill = choose_.extreme_byte();
        const bool is_even = choose_.once_in(4);
        for (uint32_t k = 0; k < s.texels.size(); ++k)
            s.texels[k] = is_even ? fill : static_cast<uint8_t>(scattered(k + fill));
    }

    // On the sphere, as far beyond it as coordinates go, at its centre, beside another vertex, or anywhere.
    SurfacePoint vertex(const TestSurface& s)
    {
        constexpr int32_t kOne = 1 << 14, kBeyond = 362, kCorner = 9461;  // all within 1 + 2^-12 of the centre
        SurfacePoint v{};
        switch (choose_.below(6)) {
            case 0:
                v[choose_.below(3)] = choose_.one_of({-kOne, kOne});
                break;
            case 1:
                v[choose_.below(2)] = choose_.one_of({-kOne, kOne});
                v[2] = choose_.one_of<int32_t>({-kBeyond, kBeyond, -1, 1});
                break;
            case 2:
                for (int32_t& c : v) c = choose_.one_of({-kCorner, kCorner});
                break;
            case 3:
                for (int32_t& c : v) c = choose_.between(-1, 1);
                break;
            case 4:
                v = s.vertices[choose_.below(static_cast<uint32_t>(s.vertices.size()))];
                for (int32_t& c : v) c -= c > 0 ? choose_.between(0, 2) : -choose_.between(0, 2);
                break;
            default:
                for (int32_t& c : v) c = choose_.between(-kCorner, kCorner);
        }
        return v;
    }

    // Each a step away from the one before: triangles of neighbours are small, down to less than a sample.
    void walk(std::vector<SurfacePoint>& vertices)
    {
        constexpr int32_t kCorner = 9461;
        const int32_t step = choose_.one_of({1, 250, 1000, 2000, 4000, 8000});
        SurfacePoint at{};
        for (int32_t& c : at) c = choose_.between(-kCorner, kCorner);
        for (SurfacePoint& v : vertices) {
            for (int32_t& c : at) c = std::clamp(c + choose_.between(-step, step), -kCorner, kCorner);
            v = at;
        }
    }

    TestPatch patch(const TestSurface& s, bool is_walk, bool has_largest_texture)
    {
        const uint32_t vertices = static_cast<uint32_t>(s.vertices.size());
        const uint32_t texels = static_cast<uint32_t>(s.texels.size()), first = choose_.below(vertices);
        const auto corner = [&](uint32_t k) { return is_walk ? (first + k) % vertices : choose_.below(vertices); };
        TestPatch p{first, corner(1), corner(2)};
        if (choose_.below(3) != 0) p.d = corner(3);
        const uint32_t widest = std::min(detail::format::kMaxPatchSide,
                                         (texels - detail::format::patch_reach(0)) / detail::format::kMaxPatchSide);
        p.columns = has_largest_texture ? widest : choose_.end_or_any(1, widest);
        p.rows =
            has_largest_texture ? detail::format::kMaxPatchSide : choose_.end_or_any(1, detail::format::kMaxPatchSide);
        p.begin = choose_.end_or_any(0, texels - detail::format::patch_reach(p.columns));
        return p;
    }

    // The other side of every patch, as far as there is room.
    void add_turned_patches(TestSurface& s) const
    {
        const size_t count = std::min(2 * s.patches.size(), size_t{limits_.patches});
        for (size_t k = 0; s.patches.size() < count; ++k) {
            TestPatch turned = s.patches[k];
            std::swap(turned.b, turned.c);
            s.patches.push_back(turned);
        }
    }

    TestSection palette()
    {
        Bytes b;
        for (uint32_t k = 0; k < 3 * detail::format::kPaletteEntries; ++k) b.push_back(choose_.extreme_byte());
        return {detail::format::kPaletteRgb, detail::format::kRequired, b};
    }
    TestSection views(const TestSurface& s)
    {
        Bytes b;
        const uint32_t records = s.viewed * detail::format::view_bytes(s.code_bits);
        for (uint32_t k = 0; k < detail::format::view_colours_bytes(s.code_bits) + records; ++k)
            b.push_back(choose_.extreme_byte());
        return {detail::format::kViewSection, 0, b};
    }
    TestSection neighbours(const TestSurface& s)
    {
        Bytes b;
        const uint32_t triangles = 2 * static_cast<uint32_t>(s.patches.size());
        for (uint32_t k = 0; k < 2 * triangles; ++k)
            put16(b, (choose_.once_in(2) ? detail::format::kNoNeighbour : choose_.below(triangles)) |
                         (choose_.once_in(4) ? detail::format::kCrease : 0));
        return {detail::format::kNeighbourSection, 0, b};
    }

    Choices& choose_;
    const SurfaceLimits limits_;
};

}  // namespace lumi::test
