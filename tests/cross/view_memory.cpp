// SPDX-License-Identifier: MIT
// The RAM that the tools tell is that of the views which this compiler makes. Nothing of it runs.
#include "lumi/host/view_memory.h"

#include "lumi/chord/view.h"
#include "lumi/surface/view.h"

namespace lumi
{
namespace
{

template <uint32_t kVertices, uint32_t kPatches, SurfaceMode kFinest, uint32_t kSeeThrough, class ScreenOf,
          uint32_t kParts = 0, uint32_t kStates = 0>
constexpr bool is_told =
    sizeof(View<SurfaceDrawing<kVertices, kPatches, kFinest, kSeeThrough, kVertices, kParts, kStates>, ScreenOf>) ==
    host::surface_view_bytes<typename ScreenOf::Pixel>({kVertices, kPatches, kFinest, kSeeThrough, kParts, kStates},
                                                       {ScreenOf::kWidthPx, ScreenOf::kHeightPx, ScreenOf::kRowsPx});

constexpr SurfaceMode kOne = SurfaceMode::one_sample, kSmooth = SurfaceMode::antialiased,
                      kFour = SurfaceMode::two_by_two;

static_assert(is_told<980, 722, kSmooth, 0, Screen<240, 240, 16>>);
static_assert(is_told<981, 723, kOne, 0, Screen<240, 240, 4>>);
static_assert(is_told<287, 147, kFour, 0, Screen<466, 466, 4>>);
static_assert(is_told<3, 1, kSmooth, 0, Screen<1, 1, 1>>);
static_assert(is_told<50, 49, kSmooth, 0, Screen<241, 7, 24>>);
static_assert(is_told<2187, 1900, kFour, 0, Screen<320, 480, 24, PixelRgb888>>);
static_assert(is_told<500, 401, kOne, 0, Screen<128, 128, 128, PixelGrey8>>);
static_assert(is_told<980, 722, kSmooth, 10, Screen<240, 240, 16>>);
static_assert(is_told<11, 1, kFour, 7, Screen<239, 100, 3, PixelArgb8888>>);
static_assert(is_told<980, 722, kSmooth, 0, Screen<240, 240, 16>, 1>);
static_assert(is_told<980, 722, kSmooth, 10, Screen<240, 240, 16>, 16>);
static_assert(is_told<980, 722, kSmooth, 0, Screen<240, 240, 16>, 0, 2>);
static_assert(is_told<980, 722, kSmooth, 10, Screen<240, 240, 16>, 16, 4>);

static_assert(sizeof(View<ChordDrawing<TexelPalette8>, Screen<>>) == host::chord_view_bytes(true));
static_assert(sizeof(View<ChordDrawing<TexelRgb565, Nearest>, Screen<466, 466, 4, PixelRgb888>>) ==
              host::chord_view_bytes(true));
static_assert(sizeof(View<ExactChordDrawing<TexelLuma8>, Screen<>>) == host::chord_view_bytes(false));

}  // namespace
}  // namespace lumi
