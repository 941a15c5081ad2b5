// SPDX-License-Identifier: MIT
// Composes guided field files from parts for tests, valid or not: written from guided_format.h, not from the
// baker's writer.
#pragma once

#include <array>

#include "field_bytes.h"
#include "lumi/guided/guided_format.h"

namespace lumi::test
{

struct TestGuided {
    uint32_t origins = 64, used_origins = 64;
    uint32_t chart_size = 8;
    format::GuidedTexel texel = format::GuidedTexel::index4;
    format::GuidedSurface surface = format::GuidedSurface::proxy;
    uint8_t colour_space = 0, reserved = 0;
    uint32_t origins_per_palette = 16;
    float centre[3] = {1, 2, 3};
    float radius = 4;
    int32_t focus_q14[3] = {};
    uint32_t focus_radius_q14 = 0;
    uint32_t reserved2 = 0;
};

inline TestSection guided_section(const TestGuided& g)
{
    Bytes b;
    put32(b, g.origins);
    put32(b, g.used_origins);
    put16(b, g.chart_size);
    b.push_back(static_cast<uint8_t>(g.texel));
    b.push_back(static_cast<uint8_t>(g.surface));
    b.push_back(g.colour_space);
    b.push_back(g.reserved);
    put16(b, g.origins_per_palette);
    for (const float c : g.centre) put32(b, float_bits(c));
    put32(b, float_bits(g.radius));
    for (const int32_t c : g.focus_q14) put16(b, static_cast<uint32_t>(c) & 0xFFFF);
    put16(b, g.focus_radius_q14);
    put32(b, g.reserved2);
    return {format::kGuidedSection, format::kRequired, b};
}

// Three numbers of 12 bits: a vertex (c stands for (c - 2048)/2048) or a triangle's corners.
using Triple = std::array<uint32_t, 3>;

inline void put_triples(Bytes& b, const std::vector<Triple>& triples)
{
    Bytes block((triples.size() * 36 + 7) / 8, 0);
    size_t bit = 0;
    for (const Triple& t : triples) {
        for (const uint32_t value : t) {
            for (uint32_t k = 0; k < 12; ++k, ++bit) {
                block[bit / 8] = static_cast<uint8_t>(block[bit / 8] | (value >> k & 1) << (bit % 8));
            }
        }
    }
    b.insert(b.end(), block.begin(), block.end());
}

struct TestMesh {
    std::vector<Triple> vertices, triangles;
    uint32_t flags = 0;
};

// A tetrahedron around the centre, its triangles counter-clockwise seen from outside.
inline TestMesh tetrahedron()
{
    return {{{3072, 3072, 3072}, {3072, 1024, 1024}, {1024, 3072, 1024}, {1024, 1024, 3072}},
            {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

inline TestSection proxy_section(const TestMesh& mesh)
{
    Bytes b;
    put16(b, static_cast<uint32_t>(mesh.vertices.size()));
    put16(b, static_cast<uint32_t>(mesh.triangles.size()));
    put32(b, mesh.flags);
    put_triples(b, mesh.vertices);
    b.resize((b.size() + 3) & ~size_t{3});
    put_triples(b, mesh.triangles);
    return {format::kProxySection, format::kRequired, b};
}

struct TestMean {
    uint32_t resolution = 15;
    format::MeanFormat format = format::MeanFormat::rgb565;
    std::array<uint32_t, 3> first_brick = {1, 1, 1}, box = {2, 2, 2};
    uint32_t bricks = 4;
};

// Index entries and nodes' bytes from functions of their number.
template <class Index, class Node>
TestSection mean_section(const TestMean& mean, Index index, Node node)
{
    const bool indexed = mean.format == format::MeanFormat::palette8;
    Bytes b;
    put16(b, mean.resolution);
    b.push_back(static_cast<uint8_t>(mean.format));
    b.push_back(0);
    for (const uint32_t v : mean.first_brick) b.push_back(static_cast<uint8_t>(v));
    b.push_back(0);
    for (const uint32_t v : mean.box) b.push_back(static_cast<uint8_t>(v));
    b.push_back(0);
    put16(b, mean.bricks);
    put16(b, 0);
    if (indexed) {
        for (uint32_t k = 0; k < 256; ++k) put32(b, k | (255 - k) << 8 | (k / 2) << 16);
    }
    for (uint32_t k = 0; k < mean.box[0] * mean.box[1] * mean.box[2]; ++k) put16(b, index(k));
    b.resize((b.size() + 3) & ~size_t{3});
    for (uint32_t k = 0; k < mean.bricks * format::kBrickNodes * (indexed ? 1 : 2); ++k) b.push_back(node(k));
    return {format::kMeanSection, 0, b};
}

// The rows of one origin's chart: row first_row + i holds grid points first_u[i] .. first_u[i] + counts[i] - 1.
struct TestChartRows {
    uint32_t first_row = 0;
    std::vector<uint32_t> first_u, counts;
};

// A full disc of rows of a chart of G grid points, the same for every origin.
inline TestChartRows full_rows(uint32_t size)
{
    TestChartRows rows;
    const uint32_t side = 2 * format::chart_centre(size) + 1;
    rows.first_u.assign(side, 0);
    rows.counts.assign(side, side);
    return rows;
}

// The same of blocks of 2×2 grid points.
inline TestChartRows full_block_rows(uint32_t size)
{
    TestChartRows rows;
    const uint32_t side = format::chart_centre(size) + 1;
    rows.first_u.assign(side, 0);
    rows.counts.assign(side, side);
    return rows;
}

// What a full chart's table holds rows of: grid points or blocks.
inline TestChartRows full_chart_rows(const TestGuided& g)
{
    return g.texel == format::GuidedTexel::vq8 ? full_block_rows(g.chart_size) : full_rows(g.chart_size);
}

// A chart table with texels from a function of (origin, number in the origin), 4 bits or 8 bits each.
template <class Texel>
TestSection table_section(uint32_t type, bool nibbles, const std::vector<TestChartRows>& origins, Texel texel)
{
    Bytes directory, rows, texels;
    uint32_t row_base = 0, texel_base = 0;
    for (uint32_t i = 0; i < origins.size(); ++i) {
        const TestChartRows& chart = origins[i];
        const uint32_t first_texel = texel_base;
        put32(directory, texel_base);
        put32(directory, row_base);
        put16(directory, chart.first_row);
        put16(directory, static_cast<uint32_t>(chart.counts.size()));
        for (size_t r = 0; r < chart.counts.size(); ++r) {
            put16(rows, (texel_base - first_texel - chart.first_u[r]) & 0xFFFF);
            for (uint32_t k = 0; k < chart.counts[r]; ++k, ++texel_base) {
                const uint32_t value = texel(i, texel_base - first_texel);
                if (!nibbles || texel_base % 2 == 0) texels.push_back(0);
                uint8_t& last = texels.back();
                last = static_cast<uint8_t>(last | value << (nibbles && texel_base % 2 == 1 ? 4 : 0));
            }
        }
        row_base += static_cast<uint32_t>(chart.counts.size());
    }
    rows.resize((rows.size() + 3) & ~size_t{3});
    Bytes b;
    put32(b, row_base);
    put32(b, texel_base);
    b.insert(b.end(), directory.begin(), directory.end());
    b.insert(b.end(), rows.begin(), rows.end());
    b.insert(b.end(), texels.begin(), texels.end());
    return {type, type == format::kChartSection ? format::kRequired : 0, b};
}

// Palettes of every group from a function of (group, entry) -> r | g << 8 | b << 16; entry 0 is 0.
template <class Colour>
TestSection chart_colours_section(const TestGuided& g, Colour colour)
{
    Bytes b;
    const uint32_t groups = (g.used_origins + g.origins_per_palette - 1) / g.origins_per_palette;
    const uint32_t entries = format::chart_colours(g.texel);
    for (uint32_t group = 0; group < groups; ++group) {
        for (uint32_t k = 0; k < entries; ++k) put32(b, k == 0 ? 0 : colour(group, k) & 0xFFFFFF);
    }
    return {format::kChartColours, format::kRequired, b};
}

// Depths that hide some of what an origin sees.
inline TestSection occlusion_section(const TestGuided& g)
{
    TestChartRows coarse = full_rows(g.chart_size);
    const uint32_t side = static_cast<uint32_t>(coarse.counts.size() >> format::kOcclusionShift) + 1;
    coarse.first_u.assign(side, 0);
    coarse.counts.assign(side, side);
    return table_section(format::kOcclusionSection, false, std::vector(g.used_origins, coarse),
                         [](uint32_t i, uint32_t k) { return 120 + (i * 5 + k * 17) % 136; });
}

// A small field with every section: mesh, mean of `mean_format`, charts of full discs, occlusion.
inline std::vector<TestSection> sample_guided_sections(const TestGuided& g, const TestMesh& mesh = tetrahedron(),
                                                       const TestMean& mean = {})
{
    using format::GuidedSurface, format::GuidedTexel;
    const bool meshed = g.surface == GuidedSurface::proxy;
    std::vector<TestSection> sections = {guided_section(g)};
    if (meshed) sections.push_back(proxy_section(mesh));
    sections.push_back(mean_section(
        mean, [&](uint32_t k) { return k % mean.bricks; }, [](uint32_t k) { return static_cast<uint8_t>(k * 37); }));
    if (g.texel == GuidedTexel::none) return sections;
    const std::vector<TestChartRows> charts(g.used_origins, full_chart_rows(g));
    const bool nibbles = g.texel == GuidedTexel::index4;
    const uint32_t entries = nibbles ? 16 : 256;
    sections.push_back(table_section(format::kChartSection, nibbles, charts,
                                     [&](uint32_t i, uint32_t k) { return (i * 7 + k * 3 + k / 11) % entries; }));
    sections.push_back(
        chart_colours_section(g, [](uint32_t group, uint32_t k) { return group * 0x050301 + k * 0x0B0D07; }));
    if (!meshed) return sections;
    sections.push_back(occlusion_section(g));
    return sections;
}

inline Bytes sample_guided(const TestGuided& g, const TestMesh& mesh = tetrahedron(), const TestMean& mean = {})
{
    return file_of(sample_guided_sections(g, mesh, mean));
}

}  // namespace lumi::test
