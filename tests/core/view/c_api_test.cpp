// SPDX-License-Identifier: MIT
// lumi.h with its default macros: surface fields, RGB565 for SPI panels, over black.
#include <catch2/catch.hpp>
#include <string>

#include "lumi/lumi.h"
#include "lumi/surface/view.h"
#include "surface/surface_bytes.h"

using namespace lumi;
using namespace lumi::detail;
using test::Bytes;

namespace
{

constexpr int32_t kWidth = 48, kHeight = 37, kRows = 8;
constexpr uint32_t kStride = 2 * kWidth;
constexpr lumi_orbit kOrbit = {LUMI_DEGREES(30), LUMI_DEGREES(-20), LUMI_RADII(5) / 2, LUMI_FIT_SPHERE, LUMI_NO_ZOOM};

uint64_t memory[LUMI_MEMORY_TWO_BY_TWO(98, 128, kWidth, kHeight, kRows) / 8 + 1];

const Bytes& ball()
{
    static const Bytes bytes = test::surface_file(test::bumpy_ball());
    return bytes;
}

lumi_screen screen_of(uint8_t mode)
{
    return {kWidth, kHeight, kRows, mode};
}

lumi_error code(ViewError error)
{
    return static_cast<lumi_error>(error);
}

lumi_view* opened(uint8_t mode)
{
    lumi_view* view = nullptr;
    REQUIRE(lumi_open(memory, sizeof memory, ball().data(), ball().size(), screen_of(mode), &view) == 0);
    return view;
}

// The answer of lumi_open to arguments that are right but for these.
lumi_error open_error(void* at, size_t bytes, const Bytes& field, size_t field_bytes, const lumi_screen& screen)
{
    lumi_view* view = reinterpret_cast<lumi_view*>(memory);
    const lumi_error error = lumi_open(at, bytes, field.data(), field_bytes, screen, &view);
    CHECK((view == nullptr) == (error != 0));
    return error;
}

}  // namespace

TEST_CASE("memory of the size that is told is enough, and a byte less is an error")
{
    for (const uint8_t mode : {uint8_t{LUMI_ANTIALIASED}, uint8_t{LUMI_TWO_BY_TWO}}) {
        const size_t size = lumi_memory_size(ball().data(), ball().size(), screen_of(mode));
        CHECK(size > 0);
        CHECK(size <= sizeof memory);
        CHECK(open_error(memory, size, ball(), ball().size(), screen_of(mode)) == 0);
        CHECK(open_error(memory, size - 1, ball(), ball().size(), screen_of(mode)) ==
              code(ViewError::memory_too_small));
    }
    CHECK(lumi_memory_size(ball().data(), ball().size(), screen_of(LUMI_ANTIALIASED)) <=
          LUMI_MEMORY(98, 118, kWidth, kHeight, kRows));
    CHECK(lumi_memory_size(ball().data(), 100, screen_of(0)) == 0);
    CHECK(lumi_memory_size(nullptr, 100, screen_of(0)) == 0);
}

TEST_CASE("wrong arguments of lumi_open are errors, each by name")
{
    const Bytes& bytes = ball();
    const lumi_screen screen = screen_of(LUMI_ANTIALIASED);
    uint8_t* const base = reinterpret_cast<uint8_t*>(memory);
    CHECK(open_error(base + 4, sizeof memory - 8, bytes, bytes.size(), screen) == code(ViewError::unaligned_memory));
    CHECK(open_error(nullptr, sizeof memory, bytes, bytes.size(), screen) == code(ViewError::bad_argument));
    CHECK(open_error(memory, 8, bytes, bytes.size(), screen) == code(ViewError::memory_too_small));
    CHECK(open_error(memory, sizeof memory, bytes, bytes.size() / 2, screen) ==
          code(view_error(FieldError::truncated)));
    CHECK(open_error(memory, sizeof memory, Bytes(4000, 0xFF), 4000, screen) ==
          code(view_error(FieldError::bad_magic)));
    test::TestLayout chord;
    const Bytes other = test::sample_field(chord);
    CHECK(open_error(memory, sizeof memory, other, other.size(), screen) == code(ViewError::other_renderer));
    const lumi_screen wrong[] = {{0, 37, 8, 1},  {8193, 37, 8, 1}, {48, 0, 8, 1}, {48, 8193, 8, 1},
                                 {48, 37, 0, 1}, {48, 37, 38, 1},  {48, 37, 8, 3}};
    for (const lumi_screen& s : wrong)
        CHECK(open_error(memory, sizeof memory, bytes, bytes.size(), s) == code(ViewError::bad_argument));
    CHECK(lumi_open(memory, sizeof memory, bytes.data(), bytes.size(), screen, nullptr) ==
          code(ViewError::bad_argument));
}

TEST_CASE("lumi_verify tells every damaged part of a field")
{
    CHECK(lumi_verify(ball().data(), ball().size()) == 0);
    CHECK(lumi_verify(nullptr, ball().size()) == code(ViewError::bad_argument));
    CHECK(lumi_verify(ball().data(), 0) == code(view_error(FieldError::truncated)));
    for (const size_t at : {size_t{0}, size_t{13}, ball().size() / 3, ball().size() / 2, ball().size() - 1}) {
        Bytes damaged = ball();
        damaged[at] ^= 0x10;
        CHECK(lumi_verify(damaged.data(), damaged.size()) != 0);
    }
}

TEST_CASE("wrong views and stripes are errors in C, too")
{
    alignas(4) static uint8_t pixels[kStride * (kRows + 1)];
    const lumi_stripe stripe = {pixels, 0, 0, kWidth, kRows, kStride};
    CHECK(lumi_look(nullptr, kOrbit) == code(ViewError::no_field));
    CHECK(lumi_draw(nullptr, stripe) == code(ViewError::no_field));
    lumi_view* const view = opened(LUMI_ANTIALIASED);
    CHECK(lumi_draw(view, stripe) == code(ViewError::no_look));
    CHECK(lumi_look(view, {0, 0, 0, 0, LUMI_NO_ZOOM}) == code(view_error(CameraError::eye_inside_sphere)));
    REQUIRE(lumi_look(view, kOrbit) == 0);
    CHECK(lumi_draw(view, {nullptr, 0, 0, kWidth, kRows, kStride}) == code(ViewError::no_pixels));
    CHECK(lumi_draw(view, {pixels + 1, 0, 0, kWidth, kRows, kStride}) == code(ViewError::unaligned_pixels));
    CHECK(lumi_draw(view, {pixels, 0, 0, kWidth, kRows, 4}) == code(ViewError::short_stride));
    CHECK(lumi_draw(view, {pixels, 0, INT32_MAX, kWidth, kRows, kStride}) == code(ViewError::stripe_too_far));
    CHECK(lumi_draw(view, {pixels, 0, kHeight, kWidth, kRows, kStride}) == 0);
    CHECK(lumi_draw(view, {pixels, 0, 0, kWidth, kRows + 1, kStride}) == code(ViewError::stripe_too_large));
    CHECK(lumi_draw(view, stripe) == 0);
    CHECK(lumi_bounds(nullptr).width_px == 0);
    CHECK(lumi_bounds(view).width_px > 0);
    CHECK(lumi_bounds(opened(LUMI_ANTIALIASED)).width_px == 0);  // before a look
    REQUIRE(lumi_look(view, kOrbit) == 0);
    CHECK(lumi_draw(view, stripe) == 0);
    static uint8_t tall[kWidth * (kRows + 1)];
    CHECK(lumi_draw_coverage(view, {tall, 0, 0, kWidth, kRows + 1, kWidth}) == code(ViewError::stripe_too_large));
    static uint8_t coverage[kWidth * kRows];
    CHECK(lumi_draw_coverage(view, {coverage, 0, 0, kWidth, kRows, kWidth}) == 0);
    CHECK(lumi_draw_coverage(view, {coverage, 0, 0, kWidth, kRows, kWidth - 1}) == code(ViewError::short_stride));
    CHECK(lumi_draw_coverage(view, {nullptr, 0, 0, kWidth, kRows, kWidth}) == code(ViewError::no_pixels));
    CHECK(lumi_draw_coverage(nullptr, {coverage, 0, 0, kWidth, kRows, kWidth}) == code(ViewError::no_field));
    CHECK(std::string(lumi_error_text(code(ViewError::no_look))) == error_text(ViewError::no_look));
}

TEST_CASE("angles and lengths in C are those in C++")
{
    for (int32_t d = -1000; d <= 1000; d += 7) CHECK(LUMI_DEGREES(d) == degrees(d));
    CHECK(LUMI_RADII(3) == radii(3));
}
