// SPDX-License-Identifier: MIT
// RAM of views. That it is a device's to the byte is checked where a device's compiler is: tests/cross/view_memory.cpp.
#include "lumi/host/view_memory.h"

#include <catch2/catch.hpp>

#include "lumi/chord/view.h"
#include "lumi/surface/view.h"

namespace lumi
{

namespace
{

// How much more a view takes here, where pointers have 8 bytes and objects have sizes divisible by 8.
template <uint32_t kVertices, uint32_t kPatches, SurfaceMode kFinest, class ScreenOf>
int more_here()
{
    using Here = View<SurfaceDrawing<kVertices, kPatches, kFinest>, ScreenOf>;
    const uint32_t there = host::surface_view_bytes<typename ScreenOf::Pixel>(
        {kVertices, kPatches, kFinest, 0}, {ScreenOf::kWidthPx, ScreenOf::kHeightPx, ScreenOf::kRowsPx});
    return static_cast<int>(sizeof(Here)) - static_cast<int>(there);
}

}  // namespace

TEST_CASE("views of every field, screen and mode take as many bytes more here than on a device, for their pointers")
{
    const int more = more_here<980, 722, SurfaceMode::antialiased, Screen<>>();
    CHECK(more > 0);
    for (const int other : {more_here<981, 723, SurfaceMode::one_sample, Screen<240, 240, 4>>(),
                            more_here<2187, 1900, SurfaceMode::two_by_two, Screen<466, 466, 24, PixelRgb888>>(),
                            more_here<3, 1, SurfaceMode::antialiased, Screen<1, 1, 1>>(),
                            more_here<50, 49, SurfaceMode::one_sample, Screen<241, 7, 30, PixelGrey8>>()})
        CHECK(std::abs(other - more) < 8);
}

TEST_CASE("the view of a chord field is as large for every screen")
{
    const auto small = sizeof(View<ChordDrawing<TexelPalette8>, Screen<10, 10, 1>>);
    CHECK(small == sizeof(View<ChordDrawing<TexelPalette8>, Screen<466, 466, 16>>));
    CHECK(small > host::chord_view_bytes(true));
    CHECK(host::chord_view_bytes(true) > host::chord_view_bytes(false));
}

TEST_CASE("a stripe has no more rows than its image")
{
    CHECK(host::stripe_pixel_bytes<PixelRgb565>({240, 240, 16}) == 7680);
    CHECK(host::stripe_pixel_bytes<PixelRgb888>({10, 3, 16}) == 90);
}

}  // namespace lumi
