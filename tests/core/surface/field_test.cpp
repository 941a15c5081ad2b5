// SPDX-License-Identifier: MIT
#include "lumi/surface/field.h"

#include <catch2/catch.hpp>

#include "lumi/chord/field.h"

#include "surface_bytes.h"
#include "truncation.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

FieldError opened(const Bytes& bytes)
{
    SurfaceField field;
    return open_surface(bytes.data(), bytes.size(), field);
}

FieldError opened_with(const std::function<void(TestSurface&)>& change)
{
    TestSurface s = bumpy_ball();
    change(s);
    return opened(surface_file(s));
}

// The file whose section of a type is cut by a byte.
FieldError opened_short(uint32_t type)
{
    std::vector<TestSection> sections = surface_sections(bumpy_ball());
    for (TestSection& s : sections)
        if (s.type == type) s.bytes.pop_back();
    return opened(file_of(sections));
}

FieldError opened_without(uint32_t type)
{
    std::vector<TestSection> kept;
    for (const TestSection& s : surface_sections(bumpy_ball()))
        if (s.type != type) kept.push_back(s);
    return opened(file_of(kept));
}

}  // namespace

TEST_CASE("a surface field opens as it was written")
{
    const TestSurface s = bumpy_ball();
    const Bytes bytes = surface_file(s);
    SurfaceField field;
    REQUIRE(open_surface(bytes.data(), bytes.size(), field) == FieldError::none);
    CHECK(verify_field(bytes.data(), bytes.size()) == FieldError::none);
    CHECK(field.vertex_count == s.vertices.size());
    CHECK(field.viewed_count == s.viewed);
    CHECK(field.patch_count == s.patches.size());
    CHECK(field.texel_bytes == s.texels.size());
    uint32_t wrong = 0;
    for (uint32_t k = 0; k < field.vertex_count; ++k) {
        const VertexQ14 v = surface_vertex(field, k);
        wrong += SurfacePoint{v.x, v.y, v.z} == s.vertices[k] ? 0u : 1u;
    }
    for (uint32_t k = 0; k < field.patch_count; ++k) {
        const SurfacePatch p = surface_patch(field, k);
        const TestPatch& t = s.patches[k];
        const bool same = p.corner[0] == t.a && p.corner[1] == t.b && p.corner[2] == t.c && p.corner[3] == t.d &&
                          p.texels == t.begin && p.columns == t.columns && p.rows == t.rows;
        wrong += same ? 0u : 1u;
    }
    CHECK(wrong == 0);
}

TEST_CASE("readers tell kinds of fields apart")
{
    const Bytes surface = surface_file(bumpy_ball());
    Field chord;
    CHECK(open_field(surface.data(), surface.size(), chord) == FieldError::surface_field);
    CHECK(opened(file_of({layout_section({})})) == FieldError::chord_field);
    CHECK(opened_without(format::kSurfaceSection) == FieldError::missing_surface);
}

TEST_CASE("surface fields of the wrong length are refused")
{
    check_other_sizes_are_refused(surface_file(bumpy_ball()), opened);
}

TEST_CASE("sections of surface fields that are cut or missing are refused by name")
{
    CHECK(opened_short(format::kSurfaceSection) == FieldError::bad_surface);
    CHECK(opened_short(format::kVertexSection) == FieldError::bad_vertices);
    CHECK(opened_short(format::kPatchSection) == FieldError::bad_patches);
    CHECK(opened_short(format::kColourSection) == FieldError::bad_texel_size);
    CHECK(opened_short(format::kPaletteRgb) == FieldError::bad_palette);
    CHECK(opened_short(format::kViewSection) == FieldError::bad_views);
    CHECK(opened_without(format::kVertexSection) == FieldError::bad_vertices);
    CHECK(opened_without(format::kViewSection) == FieldError::bad_views);
}

TEST_CASE("values out of range in surface fields are refused by name")
{
    CHECK(opened_with([](TestSurface& s) { s.reserved = 1; }) == FieldError::bad_surface);
    for (uint32_t shadows = 1; shadows <= 0x8000; shadows *= 2)
        CHECK(opened_with([shadows](TestSurface& s) { s.shadows = shadows; }) == FieldError::bad_surface);
    CHECK(opened_with([](TestSurface& s) { s.colour_space = 1; }) == FieldError::bad_colour_space);
    CHECK(opened_with([](TestSurface& s) { s.longest_edge_q6 = 0; }) == FieldError::bad_surface);
    CHECK(opened_with([](TestSurface& s) { s.longest_edge_q6 = 129; }) == FieldError::bad_surface);
    CHECK(opened_with([](TestSurface& s) { s.radius = 0; }) == FieldError::bad_bounds);
    CHECK(opened_with([](TestSurface& s) { s.viewed = static_cast<uint32_t>(s.vertices.size()) + 1; }) ==
          FieldError::bad_surface);
    CHECK(opened_with([](TestSurface& s) { s.vertices[3] = {16385, 0, 0}; }) == FieldError::bad_vertices);
    CHECK(opened_with([](TestSurface& s) { s.vertices[3] = {-32768, 0, 0}; }) == FieldError::bad_vertices);
    CHECK(opened_with([](TestSurface& s) { s.vertices[3] = {12000, 12000, 0}; }) == FieldError::bad_vertices);
    CHECK(opened_with([](TestSurface& s) { s.patches[0].a = static_cast<uint32_t>(s.vertices.size()); }) ==
          FieldError::bad_patches);
    CHECK(opened_with([](TestSurface& s) { s.patches[0].d = static_cast<uint32_t>(s.vertices.size()); }) ==
          FieldError::bad_patches);
    CHECK(opened_with([](TestSurface& s) { s.patches[0].columns = 0; }) == FieldError::bad_patches);
    CHECK(opened_with([](TestSurface& s) { s.patches[0].rows = 0; }) == FieldError::bad_patches);
    CHECK(opened_with([](TestSurface& s) { s.texels.pop_back(); }) == FieldError::bad_patches);
}

TEST_CASE("counts of surface fields are taken up to their limits and not beyond")
{
    const auto opened_count = [](uint32_t at, uint32_t count, bool is_long = false) {
        std::vector<TestSection> sections = surface_sections(bumpy_ball());
        for (TestSection& s : sections) {
            if (s.type != format::kSurfaceSection) continue;
            for (uint32_t k = 0; k < (is_long ? 4u : 2u); ++k) s.bytes[at + k] = static_cast<uint8_t>(count >> 8 * k);
        }
        return opened(file_of(sections));
    };
    using namespace format;
    for (const uint32_t vertices : std::initializer_list<uint32_t>{0u, 2u, kMaxSurfaceVertices + 1, 65535u})
        CHECK(opened_count(surface::kVerticesAt, vertices) == FieldError::bad_surface);
    CHECK(opened_count(surface::kVerticesAt, kMaxSurfaceVertices) ==
          FieldError::bad_vertices);  // not so many are there
    for (const uint32_t patches : std::initializer_list<uint32_t>{0u, kMaxPatches + 1, 65535u})
        CHECK(opened_count(surface::kPatchesAt, patches) == FieldError::bad_surface);
    CHECK(opened_count(surface::kPatchesAt, kMaxPatches) == FieldError::bad_patches);
    for (const uint32_t texels : std::initializer_list<uint32_t>{0u, kMaxSurfaceTexels + 1, UINT32_MAX})
        CHECK(opened_count(surface::kTexelsAt, texels, true) == FieldError::bad_surface);
    for (const uint32_t texels : std::initializer_list<uint32_t>{1u, kMaxSurfaceTexels})
        CHECK(opened_count(surface::kTexelsAt, texels, true) == FieldError::bad_texel_size);
    TestSurface three = bumpy_ball();
    three.vertices.resize(3);
    three.patches = {{0, 1, 2}};
    three.viewed = 3;
    CHECK(opened(surface_file(three)) == FieldError::none);
}

TEST_CASE("view tables and neighbours are optional, and of the right size where they are")
{
    CHECK(opened_with([](TestSurface& s) { s.viewed = 0; }) == FieldError::none);
    CHECK(opened_with([](TestSurface& s) { s.has_neighbours = false; }) == FieldError::none);
    CHECK(opened_short(format::kNeighbourSection) == FieldError::bad_neighbours);
    for (uint32_t bits = 1; bits <= format::kMaxCodeBits; ++bits)
        CHECK(opened_with([bits](TestSurface& s) { s.code_bits = bits; }) == FieldError::none);
    TestSurface s = bumpy_ball();
    const TestSection views = view_section(s);
    s.viewed = 0;
    std::vector<TestSection> sections = surface_sections(s);
    sections.push_back(views);
    CHECK(opened(file_of(sections)) == FieldError::bad_views);
}

TEST_CASE("view tables of an older format, and codes of more bits than there are, are refused")
{
    const auto opened_with_bits = [](TestSurface s, uint8_t bits) {
        std::vector<TestSection> sections = surface_sections(s);
        for (TestSection& section : sections)
            if (section.type == format::kSurfaceSection) section.bytes[format::surface::kCodeBitsAt] = bits;
        return opened(file_of(sections));
    };
    const TestSurface s = bumpy_ball();
    for (const int bits : {0, 3, 5, 9, 255})
        CHECK(opened_with_bits(s, static_cast<uint8_t>(bits)) == FieldError::bad_views);
    CHECK(opened_with_bits(s, 4) == FieldError::none);
    TestSurface without = s;
    without.viewed = 0;
    CHECK(opened_with_bits(without, 4) == FieldError::bad_views);
    CHECK(std::string(describe(FieldError::bad_views)).find("older format") != std::string::npos);
}

TEST_CASE("a required section that a surface field's reader does not know is refused")
{
    std::vector<TestSection> sections = surface_sections(bumpy_ball());
    sections.push_back({format::four_cc('N', 'E', 'W', '1'), 0, Bytes(5, 1)});
    CHECK(opened(file_of(sections)) == FieldError::none);
    sections.back().flags = format::kRequired;
    CHECK(opened(file_of(sections)) == FieldError::unknown_required);
}

TEST_CASE("neighbours of surface fields that do not exist are refused")
{
    const auto neighbours_with = [](uint32_t triangle) {
        TestSurface s = bumpy_ball();
        s.has_neighbours = false;
        Bytes b;
        for (size_t k = 0; k < 4 * s.patches.size(); ++k) put16(b, k == 7 ? triangle : format::kNoNeighbour);
        std::vector<TestSection> sections = surface_sections(s);
        sections.push_back({format::kNeighbourSection, 0, b});
        return opened(file_of(sections));
    };
    const uint32_t triangles = 2 * static_cast<uint32_t>(bumpy_ball().patches.size());
    CHECK(neighbours_with(triangles - 1) == FieldError::none);
    CHECK(neighbours_with(triangles) == FieldError::bad_neighbours);
    CHECK(neighbours_with((triangles - 1) | format::kCrease) == FieldError::none);
    CHECK(neighbours_with(format::kNoNeighbour | format::kCrease) == FieldError::none);
    CHECK(neighbours_with(triangles | format::kCrease) == FieldError::bad_neighbours);
}
