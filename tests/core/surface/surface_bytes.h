// SPDX-License-Identifier: MIT
// Composes surface field files for tests, valid or not: written from surface/format.h, not from the baker's writer.
#pragma once

#include <array>
#include <cmath>
#include <map>

#include "field_bytes.h"
#include "lumi/surface/format.h"

namespace lumi::test
{

using SurfacePoint = std::array<int32_t, 3>;  // Q14

struct TestPatch {
    uint32_t a, b, c, d = detail::format::kNoVertex;
    uint32_t begin = 0, columns = 1, rows = 1;
};

struct TestSurface {
    std::vector<SurfacePoint> vertices;
    std::vector<TestPatch> patches;
    Bytes texels;
    uint32_t viewed = 0;  // the first so many vertices have view tables
    uint32_t code_bits = 4;
    bool has_neighbours = true;
    uint32_t shadows = 0, colour_space = 0, longest_edge_q6 = 128, reserved = 0;
    float centre[3] = {1, 2, 3};
    float radius = 4;
};

// Some bytes that look like chance and are the same everywhere.
inline uint32_t scattered(uint32_t k)
{
    k = (k ^ 0x5BD1E995) * 0x9E3779B1;
    return (k ^ k >> 15) * 0x85EBCA6B >> 8;
}

inline TestSection surface_section(const TestSurface& s)
{
    Bytes b;
    put16(b, static_cast<uint32_t>(s.vertices.size()));
    put16(b, s.viewed);
    put16(b, static_cast<uint32_t>(s.patches.size()));
    put16(b, s.shadows);
    put32(b, static_cast<uint32_t>(s.texels.size()));
    b.push_back(static_cast<uint8_t>(s.colour_space));
    b.push_back(static_cast<uint8_t>(s.longest_edge_q6));
    b.push_back(static_cast<uint8_t>(s.viewed == 0 ? 0 : s.code_bits));
    b.push_back(static_cast<uint8_t>(s.reserved));
    for (const float c : s.centre) put32(b, float_bits(c));
    put32(b, float_bits(s.radius));
    return {detail::format::kSurfaceSection, detail::format::kRequired, b};
}

inline TestSection vertex_section(const TestSurface& s)
{
    Bytes b;
    for (const SurfacePoint& v : s.vertices)
        for (const int32_t c : v) put16(b, static_cast<uint32_t>(c) & 0xFFFF);
    return {detail::format::kVertexSection, detail::format::kRequired, b};
}

inline TestSection patch_section(const TestSurface& s)
{
    Bytes b;
    for (const TestPatch& p : s.patches) {
        for (const uint32_t corner : {p.a, p.b, p.c, p.d}) put16(b, corner);
        put32(b, p.begin | p.columns << 20 | p.rows << 26);
    }
    return {detail::format::kPatchSection, detail::format::kRequired, b};
}

// Colours that go round the wheel.
inline TestSection surface_palette_section()
{
    Bytes b;
    for (uint32_t k = 0; k < 256; ++k)
        for (const uint32_t channel : {k, 255 - k, 40 + k / 2 + 64 * (k & 1)})
            b.push_back(static_cast<uint8_t>(channel));
    return {detail::format::kPaletteRgb, detail::format::kRequired, b};
}

// Half a turn about h takes +z to where the vertex lies from the centre.
inline void put_turn(Bytes& b, const SurfacePoint& v)
{
    const double length = std::sqrt(double(v[0]) * v[0] + double(v[1]) * v[1] + double(v[2]) * v[2]);
    const double h[3] = {v[0] / length, v[1] / length, v[2] / length + 1};
    const double norm = std::sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
    for (int k = 0; k < 3; ++k) {
        const double along = norm > 1e-6 ? h[k] / norm : k == 0 ? 1 : 0;
        b.push_back(static_cast<uint8_t>(static_cast<int8_t>(std::lround(along * 127))));
    }
}

inline TestSection view_section(const TestSurface& s)
{
    Bytes b;
    for (uint32_t k = 0; k < detail::format::view_colours_bytes(s.code_bits); ++k)
        b.push_back(static_cast<uint8_t>(scattered(k)));
    const uint32_t codes = detail::format::view_turn_at(s.code_bits);
    for (uint32_t v = 0; v < s.viewed; ++v) {
        for (uint32_t k = 0; k < codes; ++k) b.push_back(static_cast<uint8_t>(scattered(v * codes + k)));
        put_turn(b, s.vertices[v]);
        for (uint32_t c = 0; c < detail::format::kGainBytes; ++c) b.push_back(static_cast<uint8_t>(20 + 3 * v + c));
    }
    return {detail::format::kViewSection, 0, b};
}

// By directed sides: across from->to lies the triangle with to->from.
inline TestSection neighbour_section(const TestSurface& s)
{
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> sides;
    for (uint32_t k = 0; k < s.patches.size(); ++k) {
        const auto& [a, b, c, d, begin, columns, rows] = s.patches[k];
        sides.insert({{{a, b}, 2 * k}, {{b, c}, 2 * k}, {{c, a}, 2 * k}});
        if (d != detail::format::kNoVertex)
            sides.insert({{{d, c}, 2 * k + 1}, {{c, b}, 2 * k + 1}, {{b, d}, 2 * k + 1}});
    }
    const auto across = [&](uint32_t from, uint32_t to) {
        const auto it = sides.find({to, from});
        return it == sides.end() ? detail::format::kNoNeighbour : it->second;
    };
    Bytes bytes;
    for (const auto& [a, b, c, d, begin, columns, rows] : s.patches) {
        const bool is_lone = d == detail::format::kNoVertex;
        put16(bytes, across(a, b));
        put16(bytes, across(c, a));
        put16(bytes, is_lone ? across(b, c) : across(d, c));
        put16(bytes, is_lone ? detail::format::kNoNeighbour : across(b, d));
    }
    return {detail::format::kNeighbourSection, 0, bytes};
}

inline std::vector<TestSection> surface_sections(const TestSurface& s)
{
    std::vector<TestSection> sections = {surface_section(s),
                                         vertex_section(s),
                                         patch_section(s),
                                         {detail::format::kColourSection, detail::format::kRequired, s.texels},
                                         surface_palette_section()};
    if (s.viewed != 0) sections.push_back(view_section(s));
    if (s.has_neighbours) sections.push_back(neighbour_section(s));
    return sections;
}

inline Bytes surface_file(const TestSurface& s)
{
    return file_of(surface_sections(s));
}

// Rectangles of many sizes, one after the other, and texels for them.
inline void put_texels(TestSurface& s)
{
    uint32_t begin = 0, end = 0;
    for (uint32_t k = 0; k < s.patches.size(); ++k) {
        TestPatch& p = s.patches[k];
        p.begin = begin;
        p.columns = 1 + scattered(k) % 12;
        p.rows = 1 + scattered(k + 1000) % 9;
        begin += p.columns * p.rows;
        end = std::max(end, p.begin + detail::format::patch_reach(p.columns));
    }
    for (uint32_t k = 0; k < end; ++k) s.texels.push_back(static_cast<uint8_t>(k * 3 + scattered(k) % 40));
}

// A cube of `side` × `side` patches a face, blown up to a ball with bumps; its vertices on the axes reach the sphere.
class BumpyBall
{
public:
    explicit BumpyBall(int side) : side_(side)
    {
        for (int face = 0; face < 6; ++face)
            for (int i = 0; i < side * side; ++i) add_patch(face, i % side, i / side);
    }

    TestSurface take() { return std::move(surface_); }

private:
    // Column and row of a face to cube coordinates: columns × rows point outward.
    SurfacePoint on_cube(int face, int column, int row) const
    {
        const int u = 2 * column - side_, v = 2 * row - side_;
        const size_t axis = static_cast<size_t>(face % 3);
        SurfacePoint p{};
        p[axis] = face < 3 ? side_ : -side_;
        p[(axis + 1) % 3] = face < 3 ? u : v;
        p[(axis + 2) % 3] = face < 3 ? v : u;
        return p;
    }

    uint32_t vertex(const SurfacePoint& cube)
    {
        const auto [known, is_new] = numbers_.try_emplace(cube, static_cast<uint32_t>(surface_.vertices.size()));
        if (!is_new) return known->second;
        const double x = cube[0], y = cube[1], z = cube[2], length = std::sqrt(x * x + y * y + z * z);
        const bool on_axis = length < side_ + 0.5;
        const double bump = 0.72 + 0.16 * std::sin(1.7 * x - 0.9 * y) * std::cos(1.3 * z + 0.4 * x);
        const double scale = (on_axis ? 1 : bump) * 16384 / length;
        const auto q14 = [&](double c) { return static_cast<int32_t>(std::lround(c * scale)); };
        surface_.vertices.push_back({q14(x), q14(y), q14(z)});
        return known->second;
    }

    void add_patch(int face, int column, int row)
    {
        const auto at = [&](int i, int j) { return vertex(on_cube(face, column + i, row + j)); };
        const uint32_t a = at(0, 0), b = at(1, 0), c = at(0, 1), d = at(1, 1);
        if ((face + column + row) % 5 != 0) {
            surface_.patches.push_back({a, b, c, d});
        } else {
            surface_.patches.push_back({a, b, c});
            surface_.patches.push_back({d, c, b});
        }
    }

    const int side_;
    TestSurface surface_;
    std::map<SurfacePoint, uint32_t> numbers_;
};

// Closed, with lone triangles and pairs, view tables on most vertices, a triangle right through it and one without
// area.
inline TestSurface bumpy_ball()
{
    TestSurface s = BumpyBall(4).take();
    const auto last = static_cast<uint32_t>(s.vertices.size()) - 1;
    s.patches.push_back({0, last / 2, last});
    s.patches.push_back({1, 2, 2});
    s.viewed = last - 20;
    put_texels(s);
    return s;
}

// An open sheet without view tables: each of its sides has vertices and patches of its own.
inline TestSurface wavy_sheet()
{
    constexpr int kSide = 7, kPoints = kSide * kSide;
    TestSurface s;
    for (int i = 0; i < 2 * kPoints; ++i) {
        const int x = 4000 * (i % kSide) - 12000, y = 3500 * (i % kPoints / kSide) - 10500;
        s.vertices.push_back({x, y, static_cast<int32_t>(std::lround(2500 * std::sin(x * 3e-4 + y * 2e-4)))});
    }
    for (uint32_t a = 0; a + kSide < kPoints; ++a) {
        if (a % kSide == kSide - 1) continue;
        const uint32_t b = a + 1, c = a + kSide, d = b + kSide;
        s.patches.push_back({a, b, c, d});
        s.patches.push_back({a + kPoints, c + kPoints, b + kPoints, d + kPoints});
    }
    put_texels(s);
    return s;
}

}  // namespace lumi::test
