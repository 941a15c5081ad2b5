// SPDX-License-Identifier: MIT
#include "lumi/guided/guided_field.h"

#include <catch2/catch.hpp>
#include <functional>

#include "guided/guided_opening.h"

using namespace lumi;
using namespace lumi::test;
using format::GuidedSurface;
using format::GuidedTexel;

namespace
{

// The sample's sections with one of them changed.
FieldError open_with(const TestGuided& g, uint32_t type, const std::function<void(Bytes&)>& change)
{
    std::vector<TestSection> sections = sample_guided_sections(g);
    for (TestSection& s : sections) {
        if (s.type == type) change(s.bytes);
    }
    return open_copy(file_of(sections));
}

void set16(Bytes& b, size_t at, uint32_t v)
{
    b[at] = static_cast<uint8_t>(v);
    b[at + 1] = static_cast<uint8_t>(v >> 8);
}

void set32(Bytes& b, size_t at, uint32_t v)
{
    set16(b, at, v & 0xFFFF);
    set16(b, at + 2, v >> 16);
}

}  // namespace

TEST_CASE("a well-formed guided field opens with every value in place", "[guided]")
{
    TestGuided g;
    g.used_origins = 61;
    const TestMesh mesh = tetrahedron();
    const OddCopy file(sample_guided(g, mesh));
    GuidedField field;
    REQUIRE(open_guided(file.data(), file.size, field) == FieldError::none);
    CHECK(verify_field(file.data(), file.size) == FieldError::none);
    CHECK(field.origins.size() == 64);
    CHECK(field.used_origins == 61);
    CHECK(field.chart_size == 8);
    CHECK(field.origins_per_palette == 16);
    CHECK(field.radius_bits == float_bits(4));
    CHECK(field.centre_bits[2] == float_bits(3));
    REQUIRE(field.proxy.vertex_count == 4);
    REQUIRE(field.proxy.triangle_count == 4);
    CHECK(!field.proxy.two_sided);
    for (uint32_t k = 0; k < 4; ++k) {
        const Triple12 v = triple12(field.proxy.vertices, k), t = triple12(field.proxy.triangles, k);
        CHECK(Triple{v.a, v.b, v.c} == mesh.vertices[k]);
        CHECK(Triple{t.a, t.b, t.c} == mesh.triangles[k]);
    }
    CHECK(field.mean.resolution == 15);
    CHECK(field.mean.brick_count == 4);
    CHECK(field.mean.bricks[1] == 37);
    CHECK(u16(field.mean.index + 6) == 3);
    CHECK(field.chart.texel_count == 61 * 225);
    CHECK(field.chart.row_count == 61 * 15);
    CHECK(field.occlusion.texel_count == 61 * 4);
    CHECK(u32(field.colours) == 0);
    CHECK(touch(field) < 1u << 31);
}

TEST_CASE("guided fields of every kind open", "[guided]")
{
    const uint32_t kind = GENERATE(0u, 1u, 2u, 3u, 4u, 5u, kBlocksKind);
    const Bytes bytes = small_file(kind);
    GuidedField field;
    REQUIRE(open_guided(bytes.data(), bytes.size(), field) == FieldError::none);
    CHECK((field.chart.texel_count != 0) == (field.texel != GuidedTexel::none));
    CHECK((field.occlusion.texel_count != 0) == (kind < 2 || kind == kBlocksKind));
    CHECK((field.mean.palette != nullptr) == (kind % 2 == 1));
}

TEST_CASE("each kind of field is named to the reader of the other", "[guided]")
{
    const Bytes guided = small_file(0), chord = sample_field({});
    Field field;
    CHECK(open_field(guided.data(), guided.size(), field) == FieldError::guided_field);
    CHECK(open_copy(chord) == FieldError::chord_field);
    CHECK(verify_field(chord.data(), chord.size()) == FieldError::none);
    const TestSection other = {format::four_cc('N', 'E', 'W', '1'), 0, Bytes(5, 1)};
    CHECK(open_copy(file_of({other})) == FieldError::missing_guided);
}

TEST_CASE("every truncation of a guided field's section is refused by the section's name", "[guided]")
{
    const TestGuided g = small_guided(0);
    const std::pair<uint32_t, FieldError> sections[] = {
        {format::kGuidedSection, FieldError::bad_guided},       {format::kProxySection, FieldError::bad_proxy},
        {format::kMeanSection, FieldError::bad_mean},           {format::kChartSection, FieldError::bad_chart},
        {format::kChartColours, FieldError::bad_chart_colours}, {format::kOcclusionSection, FieldError::bad_occlusion}};
    for (const auto& [type, error] : sections) {
        size_t size = 0;
        REQUIRE(open_with(g, type, [&](Bytes& b) { size = b.size(); }) == FieldError::none);
        uint32_t wrong = 0;
        for (size_t shorter = 0; shorter < size; ++shorter) {
            wrong += open_with(g, type, [&](Bytes& b) { b.resize(shorter); }) != error;
        }
        CHECK(wrong == 0);
        CHECK(open_with(g, type, [](Bytes& b) { b.push_back(0); }) == error);
    }
}

TEST_CASE("guided sections out of range are refused by name", "[guided]")
{
    const auto with = [](auto change) {
        TestGuided g = small_guided(0);
        change(g);
        return open_copy(sample_guided(g));
    };
    CHECK(with([](TestGuided& g) { g.origins = 63; }) == FieldError::bad_lattice_size);
    CHECK(with([](TestGuided& g) { g.origins = 4097; }) == FieldError::bad_lattice_size);
    CHECK(with([](TestGuided& g) { g.origins = 4096; }) == FieldError::none);
    CHECK(with([](TestGuided& g) { g.used_origins = 65; }) == FieldError::bad_lattice_size);
    CHECK(with([](TestGuided& g) { g.used_origins = 0; }) == FieldError::bad_lattice_size);
    CHECK(with([](TestGuided& g) { g.chart_size = 7; }) == FieldError::bad_chart_size);
    CHECK(with([](TestGuided& g) { g.chart_size = 401; }) == FieldError::bad_chart_size);
    CHECK(with([](TestGuided& g) { g.texel = static_cast<GuidedTexel>(4); }) == FieldError::bad_texel_format);
    CHECK(with([](TestGuided& g) { g.surface = static_cast<GuidedSurface>(2); }) == FieldError::bad_guided);
    CHECK(with([](TestGuided& g) { g.colour_space = 1; }) == FieldError::bad_colour_space);
    CHECK(with([](TestGuided& g) { g.reserved = 1; }) == FieldError::bad_guided);
    CHECK(with([](TestGuided& g) { g.reserved2 = 1; }) == FieldError::bad_guided);
    CHECK(with([](TestGuided& g) { g.radius = 0; }) == FieldError::bad_bounds);
    CHECK(with([](TestGuided& g) { g.centre[1] = INFINITY; }) == FieldError::bad_bounds);
    CHECK(with([](TestGuided& g) { g.focus_q14[1] = 1; }) == FieldError::bad_focus);
    CHECK(with([](TestGuided& g) { g.focus_radius_q14 = 1; }) == FieldError::bad_focus);
    const auto zero_group = [](Bytes& b) { set16(b, format::guided::kOriginsPerPaletteAt, 0); };
    CHECK(open_with(small_guided(0), format::kGuidedSection, zero_group) == FieldError::bad_guided);

    const auto focused = [](int32_t x, uint32_t radius) {
        TestGuided g = small_guided(3);
        g.focus_q14[0] = x;
        g.focus_radius_q14 = radius;
        return open_copy(sample_guided(g));
    };
    CHECK(focused(-16384, 16384) == FieldError::none);
    CHECK(focused(16385, 0) == FieldError::bad_focus);
    CHECK(focused(-16385, 0) == FieldError::bad_focus);
    CHECK(focused(0, 16385) == FieldError::bad_focus);
}

TEST_CASE("proxy meshes out of range are refused by name", "[guided]")
{
    const TestGuided g = small_guided(0);
    const auto with = [&](auto change) {
        TestMesh mesh = tetrahedron();
        change(mesh);
        return open_copy(sample_guided(g, mesh));
    };
    CHECK(with([](TestMesh& m) { m.flags = format::kTwoSided; }) == FieldError::none);
    CHECK(with([](TestMesh& m) { m.flags = 2; }) == FieldError::bad_proxy);
    for (size_t corner = 0; corner < 12; ++corner) {
        CHECK(with([&](TestMesh& m) { m.triangles[corner / 3][corner % 3] = 4; }) == FieldError::bad_proxy_index);
        CHECK(with([&](TestMesh& m) { m.triangles[corner / 3][corner % 3] = 4095; }) == FieldError::bad_proxy_index);
        CHECK(with([&](TestMesh& m) { m.triangles[corner / 3][corner % 3] = 3; }) == FieldError::none);
    }
    CHECK(with([](TestMesh& m) { m.vertices.resize(4096); }) == FieldError::none);
    CHECK(with([](TestMesh& m) { m.vertices.resize(4097); }) == FieldError::bad_proxy);
    CHECK(with([](TestMesh& m) { m.triangles.resize(8192); }) == FieldError::none);
    CHECK(with([](TestMesh& m) { m.triangles.resize(8193); }) == FieldError::bad_proxy);
    CHECK(with([](TestMesh& m) { m = {}; }) == FieldError::none);
    CHECK(with([](TestMesh& m) { m.vertices.clear(); }) == FieldError::bad_proxy_index);
}

TEST_CASE("mean colours out of range are refused by name", "[guided]")
{
    const TestGuided g = small_guided(2);
    const auto with = [&](auto change) {
        TestMean mean;
        change(mean);
        return open_copy(sample_guided(g, tetrahedron(), mean));
    };
    CHECK(with([](TestMean& m) { m.resolution = 7; }) == FieldError::bad_mean);
    CHECK(with([](TestMean& m) { m.resolution = 253; }) == FieldError::bad_mean);
    CHECK(with([](TestMean& m) { m.format = static_cast<format::MeanFormat>(2); }) == FieldError::bad_mean);
    CHECK(with([](TestMean& m) { m.box[2] = 0; }) == FieldError::bad_mean);
    CHECK(with([](TestMean& m) { m.first_brick[0] = 62; }) == FieldError::none);
    CHECK(with([](TestMean& m) { m.first_brick[0] = 63; }) == FieldError::bad_mean);
    CHECK(with([](TestMean& m) { m.box = {255, 1, 1}; }) == FieldError::bad_mean);
    const auto entry = [&](uint32_t k, uint32_t brick) {
        return open_with(g, format::kMeanSection, [&](Bytes& b) { set16(b, format::mean::kContentAt + 2 * k, brick); });
    };
    CHECK(entry(7, 3) == FieldError::none);
    for (const uint32_t k : {0u, 7u}) {
        CHECK(entry(k, 4) == FieldError::bad_mean_brick);
        CHECK(entry(k, 0xFFFF) == FieldError::bad_mean_brick);
    }
    for (const uint32_t reserved : {3u, 7u, 11u, 14u, 15u}) {
        CHECK(open_with(g, format::kMeanSection, [&](Bytes& b) { b[reserved] = 1; }) == FieldError::bad_mean);
    }
    CHECK(open_with(g, format::kMeanSection, [](Bytes& b) { set16(b, format::mean::kBricksAt, 0); }) ==
          FieldError::bad_mean);
}

TEST_CASE("chart and occlusion directories that leave their tables are refused by name", "[guided]")
{
    const TestGuided g = small_guided(0);
    const auto table = GENERATE(std::make_pair(format::kChartSection, FieldError::bad_chart),
                                std::make_pair(format::kOcclusionSection, FieldError::bad_occlusion));
    const auto changed = [&](uint32_t origin, uint32_t at, uint32_t value) {
        return open_with(g, table.first, [&](Bytes& b) {
            const size_t e = format::chart::kDirectoryAt + origin * format::chart::kEntryBytes + at;
            at == format::chart::kRowCountAt ? set16(b, e, value) : set32(b, e, value);
        });
    };
    const bool fine = table.first == format::kChartSection;
    const uint32_t rows = fine ? 15 : 2, texels = 3 * rows * rows;
    for (const uint32_t origin : {0u, 2u}) {
        CHECK(changed(origin, format::chart::kTexelBaseAt, texels) == FieldError::none);
        CHECK(changed(origin, format::chart::kTexelBaseAt, texels + 1) == table.second);
        CHECK(changed(origin, format::chart::kTexelBaseAt, 0xFFFFFFFF) == table.second);
        CHECK(changed(origin, format::chart::kRowBaseAt, 2 * rows) == FieldError::none);
        CHECK(changed(origin, format::chart::kRowBaseAt, 2 * rows + 1) == table.second);
        CHECK(changed(origin, format::chart::kRowBaseAt, 0xFFFFFFFF) == table.second);
        CHECK(changed(origin, format::chart::kRowCountAt, 0xFFFF) == table.second);
    }
    for (const uint32_t at : {0u, 4u}) {
        for (const uint32_t count : {0u, 1u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu}) {
            CHECK(open_with(g, table.first, [&](Bytes& b) { set32(b, at, count); }) == table.second);
        }
    }
}

TEST_CASE("a palette group whose first entry is not 0 is refused", "[guided]")
{
    const TestGuided g = small_guided(0);
    for (const uint32_t at : {0u, 3u, 64u, 67u}) {
        CHECK(open_with(g, format::kChartColours, [&](Bytes& b) { b[at] = 1; }) == FieldError::bad_chart_colours);
    }
}

TEST_CASE("a group's blocks are refused unless all 256 are there", "[guided]")
{
    const TestGuided g = small_guided(kBlocksKind);
    constexpr size_t kGroupBytes = 256 * 4 * 4;
    const auto with_size = [&](size_t size) {
        return open_with(g, format::kChartColours, [size](Bytes& b) { b.resize(size); });
    };
    CHECK(with_size(kGroupBytes) == FieldError::none);
    for (const size_t size :
         {size_t{0}, size_t{4}, size_t{64}, size_t{1024}, kGroupBytes - 1, kGroupBytes + 1, 2 * kGroupBytes}) {
        CHECK(with_size(size) == FieldError::bad_chart_colours);
    }
    for (const size_t at : {0u, 3u}) {
        CHECK(open_with(g, format::kChartColours, [&](Bytes& b) { b[at] = 1; }) == FieldError::bad_chart_colours);
    }
}

TEST_CASE("missing, doubled and useless sections of guided fields are refused by name", "[guided]")
{
    const auto without = [](uint32_t kind, uint32_t type) {
        std::vector<TestSection> sections = sample_guided_sections(small_guided(kind));
        for (size_t k = 0; k < sections.size(); ++k) {
            if (sections[k].type == type) sections.erase(sections.begin() + static_cast<long>(k));
        }
        return open_copy(file_of(sections));
    };
    CHECK(without(0, format::kProxySection) == FieldError::missing_proxy);
    CHECK(without(0, format::kMeanSection) == FieldError::none);
    CHECK(without(2, format::kMeanSection) == FieldError::missing_mean);
    CHECK(without(0, format::kChartSection) == FieldError::missing_chart);
    CHECK(without(0, format::kChartColours) == FieldError::missing_chart_colours);
    CHECK(without(kBlocksKind, format::kChartColours) == FieldError::missing_chart_colours);
    CHECK(without(0, format::kOcclusionSection) == FieldError::none);
    const auto with_from = [](uint32_t kind, uint32_t other_kind, uint32_t type) {
        std::vector<TestSection> sections = sample_guided_sections(small_guided(kind));
        for (const TestSection& s : sample_guided_sections(small_guided(other_kind))) {
            if (s.type == type) sections.push_back(s);
        }
        return open_copy(file_of(sections));
    };
    CHECK(with_from(3, 0, format::kProxySection) == FieldError::unused_section);
    CHECK(with_from(3, 0, format::kOcclusionSection) == FieldError::unused_section);
    CHECK(with_from(2, 0, format::kChartSection) == FieldError::unused_section);
    CHECK(with_from(2, 0, format::kChartColours) == FieldError::unused_section);
    for (const TestSection& s : sample_guided_sections(small_guided(0))) {
        CHECK(with_from(0, 0, s.type) == FieldError::duplicate_section);
    }
}
