// SPDX-License-Identifier: MIT
#include "lumi/chord/field.h"

#include <catch2/catch.hpp>
#include <memory>

#include "field_bytes.h"
#include "lumi/chord/render.h"
#include "lumi/surface/field.h"
#include "truncation.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

FieldError open(const Bytes& bytes)
{
    // An allocation of its own, so that a sanitizer sees a read past the end.
    const std::unique_ptr<uint8_t[]> copy(new uint8_t[bytes.size()]);
    std::copy(bytes.begin(), bytes.end(), copy.get());
    Field field;
    return open_field(copy.get(), bytes.size(), field);
}

template <class Texel>
void draw_all_reconstructions(const Field& field)
{
    Camera camera;
    REQUIRE(make_camera(orbit(123456789, 0x08000000, 3 * kOneQ20), {9, 9, 0x1C000000}, camera) == CameraError::none);
    uint8_t pixels[9 * 9 * 3];
    const Stripe stripe = {pixels, 0, 0, 9, 9, 27};
    const OverColour black = {{0, 0, 0}};
    REQUIRE(render<Nearest, Texel, PixelRgb888>(field, camera, black, stripe) == RenderError::none);
    REQUIRE(render<Linear, Texel, PixelRgb888>(field, camera, black, stripe) == RenderError::none);
    REQUIRE(render<Paper<5>, Texel, PixelRgb888>(field, camera, black, stripe) == RenderError::none);
}

void draw_whatever_it_holds(const Field& field)
{
    with_texel(
        field.texel_format, [&](auto texel) { draw_all_reconstructions<decltype(texel)>(field); });
}

// Opens hostile bytes; whatever is accepted must be safe to verify and to draw.
void survive(const Bytes& bytes)
{
    const std::unique_ptr<uint8_t[]> copy(new uint8_t[bytes.size() + 1]);
    std::copy(bytes.begin(), bytes.end(), copy.get() + 1);  // an odd address
    Field field;
    if (open_field(copy.get() + 1, bytes.size(), field) != FieldError::none) return;
    (void)verify_field(copy.get() + 1, bytes.size());
    draw_whatever_it_holds(field);
}

Bytes with_layout(const TestLayout& layout)
{
    return sample_field(layout);
}

}  // namespace

TEST_CASE("a well-formed field opens with every value in place", "[field]")
{
    TestLayout layout;
    layout.texel = GENERATE(from_range(std::begin(AllTexels::kFormats), std::end(AllTexels::kFormats)));
    layout.used_origins = 4;
    const Bytes bytes = sample_field(layout);
    Field field;
    REQUIRE(open_field(bytes.data(), bytes.size(), field) == FieldError::none);
    CHECK(verify_field(bytes.data(), bytes.size()) == FieldError::none);
    CHECK(field.origins.size() == 6);
    CHECK(field.directions.size() == 10);
    CHECK(field.used_origins == 4);
    CHECK(field.row_stride_bytes == layout.stride());
    CHECK(field.texel_format == layout.texel);
    CHECK(field.radius_bits == float_bits(4));
    CHECK(field.row(3) == field.texels + 3 * layout.stride());
    CHECK(field.row(4) == nullptr);
    CHECK((field.palette != nullptr) == (layout.texel == TexelFormat::palette8));
}

TEST_CASE("every truncation and one trailing byte are refused", "[field]")
{
    TestLayout layout;
    layout.texel = TexelFormat::palette8;
    const Bytes bytes = sample_field(layout);
    check_other_sizes_are_refused(bytes, open);
}

TEST_CASE("every single-byte change gives an error or a field that draws safely", "[field]")
{
    TestLayout layout;
    layout.origins = 3;
    layout.used_origins = 3;
    layout.directions = 4;
    layout.texel = GENERATE(TexelFormat::palette8, TexelFormat::rgb565);
    const Bytes bytes = sample_field(layout);
#ifdef LUMI_TEST_LIGHT
    const int values[] = {0, 255};
#else
    std::vector<int> values(256);
    for (int v = 0; v < 256; ++v) values[static_cast<size_t>(v)] = v;
#endif
    // The bytes that steer the reader: header, table and layout, with the CRCs put right so that nothing hides behind
    // them. Texels and palette are data: two values each.
    const size_t steering = format::kHeaderBytes + 3 * format::kEntryBytes + 8 + format::kLayoutBytes;
    for (size_t at = 0; at < bytes.size(); ++at) {
        for (const int v : values) {
            if (at >= steering && v != 0 && v != 255) continue;
            Bytes changed = bytes;
            changed[at] = static_cast<uint8_t>(v);
            survive(changed);
            reseal(changed);
            survive(changed);
        }
    }
    SUCCEED("nothing read outside (run under AddressSanitizer)");
}

TEST_CASE("a damaged byte of a section is found by verify_field", "[field]")
{
    Bytes bytes = sample_field({});
    bytes[bytes.size() - 3] ^= 0x10;
    Field field;
    CHECK(open_field(bytes.data(), bytes.size(), field) == FieldError::none);
    CHECK(verify_field(bytes.data(), bytes.size()) == FieldError::section_crc);
    CHECK(verify_field(bytes.data(), bytes.size() - 1) == FieldError::truncated);
    Bytes unknown = sample_field({});
    unknown[33] = 'X';
    reseal(unknown);
    CHECK(verify_field(unknown.data(), unknown.size()) == FieldError::unknown_required);
    bytes[0] ^= 1;
    CHECK(verify_field(bytes.data(), bytes.size()) == FieldError::bad_magic);
}

TEST_CASE("guided fields are refused by name", "[field]")
{
    const Bytes file = file_of({{format::kGuidedSection, format::kRequired, Bytes(44, 1)}});
    Field chord;
    SurfaceField surface;
    CHECK(open_field(file.data(), file.size(), chord) == FieldError::guided_field);
    CHECK(open_surface(file.data(), file.size(), surface) == FieldError::guided_field);
    CHECK(describe(FieldError::guided_field) == std::string("guided fields ended with version 0.1.0"));
}

TEST_CASE("header and table damage is named", "[field]")
{
    const Bytes good = sample_field({});
    const auto changed = [&](size_t at, uint8_t value, bool sealed) {
        Bytes b = good;
        b[at] = value;
        if (sealed) reseal(b);
        return open(b);
    };
    CHECK(changed(0, 'X', false) == FieldError::bad_magic);
    CHECK(changed(9, 7, false) == FieldError::header_crc);
    CHECK(changed(8, 2, true) == FieldError::unsupported_version);
    CHECK(changed(10, 33, true) == FieldError::bad_header);
    CHECK(changed(20, 1, true) == FieldError::bad_header);
    CHECK(changed(33, 'X', false) == FieldError::table_crc);
    CHECK(changed(36, 3, true) == FieldError::bad_section);    // unknown flag
    CHECK(changed(40, 1, true) == FieldError::bad_section);    // unaligned offset
    CHECK(changed(43, 255, true) == FieldError::bad_section);  // offset outside
    CHECK(changed(33, 'X', true) == FieldError::unknown_required);
}

TEST_CASE("sections: optional unknown ones are skipped, doubled and missing ones refused", "[field]")
{
    const TestLayout layout;
    const TestSection l = layout_section(layout);
    const TestSection t = texel_section(layout, [](uint32_t, uint32_t) { return uint8_t{9}; });
    const TestSection later = {format::four_cc('N', 'E', 'W', '1'), 0, Bytes(5, 1)};
    TestSection needed = later;
    needed.flags = format::kRequired;
    CHECK(open(file_of({later, l, t, later})) == FieldError::none);
    CHECK(open(file_of({l, t, needed})) == FieldError::unknown_required);
    CHECK(open(file_of({l, t, t})) == FieldError::duplicate_section);
    CHECK(open(file_of({t})) == FieldError::missing_layout);
    CHECK(open(file_of({l})) == FieldError::missing_texels);
    TestLayout indexed;
    indexed.texel = TexelFormat::palette8;
    const TestSection il = layout_section(indexed);
    const TestSection it = texel_section(indexed, [](uint32_t, uint32_t) { return uint8_t{9}; });
    CHECK(open(file_of({il, it})) == FieldError::missing_palette);
    TestSection palette = palette_section();
    palette.bytes.resize(1020);
    CHECK(open(file_of({il, it, palette})) == FieldError::bad_palette);
    palette = palette_section();
    palette.bytes[3] = 0;
    palette.bytes[0] = 1;  // brighter than its coverage
    CHECK(open(file_of({il, it, palette})) == FieldError::bad_palette);
}

TEST_CASE("layouts out of range are refused by name", "[field]")
{
    const auto with = [](auto change) {
        TestLayout layout;
        change(layout);
        return open(with_layout(layout));
    };
    CHECK(with([](TestLayout& l) { l.origins = 0; }) == FieldError::bad_lattice_size);
    CHECK(with([](TestLayout& l) { l.origins = kMaxLatticeSize + 1; }) == FieldError::bad_lattice_size);
    CHECK(with([](TestLayout& l) { l.used_origins = 7; }) == FieldError::bad_lattice_size);
    CHECK(with([](TestLayout& l) { l.used_origins = 0; }) == FieldError::bad_lattice_size);
    CHECK(with([](TestLayout& l) { l.row_stride = 29; }) == FieldError::bad_row_stride);
    CHECK(with([](TestLayout& l) { l.row_stride = 32; }) == FieldError::bad_row_stride);
    CHECK(with([](TestLayout& l) { l.row_stride = 33; }) == FieldError::none);
    CHECK(with([](TestLayout& l) { l.colour_space = 9; }) == FieldError::bad_colour_space);
    CHECK(with([](TestLayout& l) { l.radius = 0; }) == FieldError::bad_bounds);
    CHECK(with([](TestLayout& l) { l.radius = -1; }) == FieldError::bad_bounds);
    CHECK(with([](TestLayout& l) { l.radius = NAN; }) == FieldError::bad_bounds);
    CHECK(with([](TestLayout& l) { l.centre[1] = INFINITY; }) == FieldError::bad_bounds);
    CHECK(with([](TestLayout& l) { l.texel = static_cast<TexelFormat>(4); }) == FieldError::bad_texel_format);
}

TEST_CASE("a failed open leaves the field untouched", "[field]")
{
    Field field;
    field.used_origins = 77;
    Bytes bytes = sample_field({});
    bytes.pop_back();
    CHECK(open_field(bytes.data(), bytes.size(), field) != FieldError::none);
    CHECK(field.used_origins == 77);
}

TEST_CASE("row strides are odd multiples of eight bytes, never a power of two", "[field]")
{
    for (uint32_t n = 1; n < 5000; ++n) {
        const uint32_t stride = format::padded_row_stride(n, TexelFormat::rgb565);
        REQUIRE(stride >= 2 * n);
        REQUIRE(stride % 16 == 8);
        REQUIRE(!format::is_power_of_two(stride));
    }
}
