// SPDX-License-Identifier: MIT
// No span and no tile reads a texel that the field does not have: beside a row, before the first, after the last used.
#include <catch2/catch.hpp>
#include <random>

#include "chord/drawing.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr uint32_t kRandomViews = 2;
constexpr int32_t kSide = 24;
#else
constexpr uint32_t kRandomViews = 60;
constexpr int32_t kSide = 72;
#endif

const auto kOne = [](uint32_t, uint32_t) { return uint8_t{1}; };

uint32_t reads = 0;
uint32_t strays = 0;

// Looks at addresses alone. A texel's row and column are whole, so that a stray to the row beside is seen, too.
void check(const Field& field, const uint8_t* texel)
{
    const ptrdiff_t offset = texel - field.texels;
    const ptrdiff_t stride = static_cast<ptrdiff_t>(field.row_stride_bytes);
    ++reads;
    if (offset < 0 || offset / stride >= static_cast<ptrdiff_t>(field.used_origins) ||
        offset % stride >= static_cast<ptrdiff_t>(field.directions.size()))
        ++strays;
}

struct CheckedLuma8 {
    static constexpr TexelFormat kFormat = TexelFormat::luma8;
    static Rgba8 load(const Field& field, const uint8_t* texel, uint32_t)
    {
        check(field, texel);
        return {1, 1, 1, 255};
    }
};

}  // namespace

namespace lumi
{

template <bool kCoverage>
struct TexelSum<CheckedLuma8, kCoverage> {
    static constexpr int kRowBits = 8;
    static constexpr int kTapBits = 8;
    static constexpr bool kUpperHalves = false;
    static constexpr bool kLowerHalves = false;
    static constexpr int kBefore = 0;

    struct Row {
        void add(const Field& field, const uint8_t* texel, uint32_t) { check(field, texel); }
    };
    void add(const Row&, uint32_t) {}

    template <class Pixel, class Background>
    void store(const Background&, uint8_t*) const
    {
    }
};

}  // namespace lumi

TEST_CASE("spans and tiles read only texels that the field has", "[span]")
{
#ifdef LUMI_TEST_LIGHT
    const uint32_t sizes[][3] = {{64, 64, 64}, {200, 120, 300}};
#else
    const uint32_t sizes[][3] = {{64, 64, 64},      {89, 60, 610},   {300, 300, 700},
                                 {1024, 500, 2048}, {64, 64, 65536}, {6000, 5990, 100}};
#endif
    for (const auto& size : sizes) {
        const OpenField open(layout_of(size[0], size[2], TexelFormat::luma8, size[1]), kOne);
        std::vector<View> views = extreme_views(kSide);
        std::minstd_rand random(size[2]);
        for (uint32_t k = 0; k < kRandomViews; ++k) views.push_back(random_view(random, kSide));
        // Small spheres: spans and tiles that reach far over them.
        for (const int fov : {3, 6, 9, 14})
            for (const double z : {0.0, 0.9, -2.2, 3.0})
                views.push_back({"small", look_at({2, 1, z}, {0, 0, 0}, 30), {kSide, kSide, degrees(13 * fov)}});
        for (const View& view : views) {
            Camera camera;
            if (make_camera(view.pose, view.image, camera) != CameraError::none) continue;
            const OverColour grey{{1, 1, 1}};
            for (const int32_t span_px : {2, 8, 16}) {
                strays = 0;
                (void)drawn_frame<Linear, CheckedLuma8, PixelGrey8>(open.field, camera, grey, span_px);
                (void)drawn_frame<Nearest, CheckedLuma8, PixelGrey8>(open.field, camera, grey, span_px);
                INFO(view.name << ", spans of " << span_px << ", " << size[0] << " x " << size[2]);
                REQUIRE(strays == 0);
            }
        }
    }
    CHECK(reads > 10000);
}

TEST_CASE("a zone that crosses the equator reads nothing beyond the other pole", "[span]")
{
    // Found by random search: a span of an acute zone whose cells are flipped where it ends.
    TestLayout layout = layout_of(75, 75, TexelFormat::luma8);
    layout.row_stride = 80;
    const OpenField open(layout, kOne);
    const Pose pose = {{-933275, -159750, 484389},
                       {-509756008, 147859956, -933384980},
                       {72855990, -1051212415, -206314655},
                       {942211277, 161279774, -489027624}};
    strays = 0;
    (void)drawn_frame<Linear, CheckedLuma8, PixelGrey8>(open.field, camera_of(pose, {141, 34, 1392898754}), OverBlack{},
                                                        16);
    CHECK(strays == 0);
}
