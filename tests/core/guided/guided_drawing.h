// SPDX-License-Identifier: MIT
// Whole pictures of guided fields, with any policy over any surface.
#pragma once

#include <vector>

#include "guided/guided_bytes.h"
#include "guided/opened_guided.h"
#include "lumi/guided/guided_render.h"
#include "views.h"

namespace lumi::test
{

#ifdef LUMI_TEST_LIGHT
inline constexpr int32_t kSide = 20;
#else
inline constexpr int32_t kSide = 80;
#endif

using Linear3 = GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex4, NoMean, OcclusionUse::ignored>;
using Best = GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex4, MeanRgb565, OcclusionUse::read>;

// A focus field whose charts show a smooth function of the exit point's place on the disc, with holes.
inline Bytes focus_field(uint32_t origins, uint32_t used, int32_t focus_radius_q14)
{
    TestGuided g;
    g.origins = origins;
    g.used_origins = used;
    g.chart_size = 32;
    g.surface = format::GuidedSurface::focus;
    g.focus_q14[0] = 1500;
    g.focus_q14[1] = -3000;
    g.focus_q14[2] = 2500;
    g.focus_radius_q14 = static_cast<uint32_t>(focus_radius_q14);
    const TestChartRows disc = full_rows(g.chart_size);
    const uint32_t side = disc.counts[0];
    return file_of({guided_section(g),
                    table_section(format::kChartSection, true, std::vector(used, disc),
                                  [&](uint32_t, uint32_t k) {
                                      const int32_t du = static_cast<int32_t>(2 * (k % side)) - 41;
                                      const int32_t dv = static_cast<int32_t>(2 * (k / side)) - 41;
                                      const int32_t square = (du * du - du * dv + dv * dv) / 120;
                                      return static_cast<uint32_t>(square > 15 ? 0 : 15 - square);
                                  }),
                    chart_colours_section(g, [used](uint32_t group, uint32_t k) {
                        return k * 17 | (255 - k * 15) << 8 | (group * 255 / (used / 16)) << 16;
                    })});
}

inline Camera camera_of(const View& view)
{
    Camera camera;
    REQUIRE(make_camera(view.pose, view.image, camera) == CameraError::none);
    return camera;
}

inline constexpr Rgb8 kBehind = {20, 90, 160};

template <class Policy, class Surface>
std::vector<uint8_t> draw(const GuidedField& field, const Camera& camera, Surface& surface)
{
    const uint32_t width = static_cast<uint32_t>(camera.width_px());
    std::vector<uint8_t> pixels(width * static_cast<uint32_t>(camera.height_px()) * 3, 77);
    const Stripe stripe = {pixels.data(), 0, 0, camera.width_px(), camera.height_px(), width * 3};
    REQUIRE(render_guided<Policy, PixelRgb888>(field, camera, surface, OverColour{kBehind}, stripe) ==
            GuidedError::none);
    return pixels;
}

}  // namespace lumi::test
