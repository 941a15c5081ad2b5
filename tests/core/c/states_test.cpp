// SPDX-License-Identifier: MIT
// Light states by the calls of lumi.h, in a build that names them and in one that does not.
#include "c/views.h"
#include "surface/states_bytes.h"

using namespace lumi;
using namespace lumi::test;

TEST_CASE("weights without a view, or without states, are errors")
{
    CHECK(lumi_set_state(nullptr, 0, 1, 1, 1) == code(ViewError::no_field));
    CHECK(lumi_set_state(ViewInC(surface_bytes(), LUMI_ANTIALIASED).get(), 0, 1, 1, 1) != 0);
}

#ifdef LUMI_C_STATES

TEST_CASE("chord fields have no states")
{
    const ViewInC view(chord_bytes(TexelFormat::rgb565), 4);
    CHECK(lumi_set_state(view.get(), 0, 1, 1, 1) == code(ViewError::other_renderer));
}

TEST_CASE("lights that C weighs are those that C++ weighs")
{
    using LitView = lumi::View<SurfaceDrawing<200, 400, SurfaceMode::two_by_two, 70, 200, 5, 4>, TestScreen>;
    constexpr lumi_orbit kOrbit = {LUMI_DEGREES(30), LUMI_DEGREES(20), LUMI_RADII(3), LUMI_FIT_SPHERE, LUMI_NO_ZOOM};
    for (const Bytes& file : {lit_ball_file(four_states()), lit_file(shaded_ball(9))}) {
        Pair<LitView> pair(file, LUMI_TWO_BY_TWO);
        for (uint32_t k = 0; k < 6; ++k) {
            const uint16_t r = static_cast<uint16_t>(900 * k), g = static_cast<uint16_t>(4000 - 700 * k);
            REQUIRE(lumi_set_state(pair.c(), k % 2, r, g, LUMI_FULL_WEIGHT) == 0);
            REQUIRE(pair.cpp().set_state(k % 2, StateWeight{r, g, kFullWeight}) == ViewError::none);
            pair.check(frame_of(pair.screen(), 0, EYE_OF_SCREEN, OVER_DEFAULT, kOrbit));
        }
        CHECK(lumi_set_state(pair.c(), 4, 0, 0, 0) == code(ViewError::bad_argument));
    }
}

#endif
