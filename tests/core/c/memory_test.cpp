// SPDX-License-Identifier: MIT
// The macros of lumi.h tell no less memory than a view takes, for screens of many sizes.
#include "c/views.h"
#include "surface/gloss_bytes.h"

using namespace lumi;
using namespace lumi::test;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr int32_t kWidths[] = {1, 33, 240}, kHeights[] = {1, 37, 240}, kMostRows[] = {1, 3, 16};
#else
constexpr int32_t kWidths[] = {1, 2, 3, 5, 31, 32, 33, 64, 240, 241, 466, 1024, 8192};
constexpr int32_t kHeights[] = {1, 7, 37, 240, 480, 8192};
constexpr int32_t kMostRows[] = {1, 2, 3, 4, 5, 8, 15, 16, 17, 31, 100, 256, 480};
#endif

// Calls check(screen) for every screen and mode of surface fields.
template <class Check>
void for_screens(const Check& check)
{
    for (const int32_t width : kWidths)
        for (const int32_t height : kHeights)
            for (const int32_t most_rows : kMostRows)
                for (uint8_t mode = LUMI_ONE_SAMPLE; mode <= LUMI_TWO_BY_TWO; ++mode)
                    check(lumi_screen{width, height, std::min(most_rows, height), mode});
}

size_t macro_of(const SurfaceField& field, const lumi_screen& s)
{
    const uint32_t vertices = field.vertex_count, patches = field.patch_count;
    const size_t opaque = s.mode == LUMI_TWO_BY_TWO
                              ? LUMI_MEMORY_TWO_BY_TWO(vertices, patches, s.width_px, s.height_px, s.rows_px)
                              : LUMI_MEMORY(vertices, patches, s.width_px, s.height_px, s.rows_px);
    return opaque + LUMI_PARTS_MEMORY(field.part_count) +
           (field.state_count != 0 ? LUMI_STATES_MEMORY(field.see_through_count) : 0) +
           LUMI_GLOSS_MEMORY(gloss_count(field), field.viewed_count) +
           (field.see_through_count != 0 ? LUMI_SEE_THROUGH_MEMORY(field.see_through_count) : 0);
}

void check_macros(const Bytes& bytes, size_t always_linked)
{
    SurfaceField field;
    REQUIRE(open_surface<SurfaceFeatures::all>(bytes.data(), bytes.size(), field) == FieldError::none);
    uint32_t screens = 0;
    for_screens([&](const lumi_screen& s) {
        const size_t told = lumi_memory_size(bytes.data(), bytes.size(), s);
        INFO(s.width_px << " x " << s.height_px << ", " << s.rows_px << " rows, mode " << +s.mode);
        REQUIRE(told > 0);
        CHECK(told <= macro_of(field, s) + always_linked);
        ++screens;
    });
    CHECK(screens > 0);
}

}  // namespace

TEST_CASE("the memory that a macro tells is enough for every screen")
{
#ifdef LUMI_C_SEE_THROUGH
    check_macros(surface_bytes(), LUMI_SEE_THROUGH_MEMORY(0));
    check_macros(see_through_bytes(), 0);
    check_macros(mover_file(moving_ball(9)), 0);
    check_macros(lit_file(moving_ball(9), four_states()), 0);
    check_macros(lit_ball_file(four_states()), LUMI_SEE_THROUGH_MEMORY(0));
    const TestSurface glossy = ball_for_gloss();
    check_macros(glossy_file(glossy, any_gloss(glossy)), LUMI_SEE_THROUGH_MEMORY(0));
#else
    check_macros(surface_bytes(), 0);
#endif
}
