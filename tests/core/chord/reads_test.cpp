// SPDX-License-Identifier: MIT
// No span and no tile reads a texel that the field does not have: beside a row, before the first, after the last used.
#include <catch2/catch.hpp>
#include <random>

#include "field_bytes.h"
#include "lumi/chord/render_spans.h"
#include "views.h"

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
    static constexpr bool kRowByRow = false;
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
        TestLayout layout;
        layout.origins = size[0];
        layout.used_origins = size[1];
        layout.directions = size[2];
        layout.texel = TexelFormat::luma8;
        const Bytes bytes =
            file_of({layout_section(layout), texel_section(layout, [](uint32_t, uint32_t) { return uint8_t{1}; })});
        Field field;
        REQUIRE(open_field(bytes.data(), bytes.size(), field) == FieldError::none);
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
            std::vector<uint8_t> pixels(static_cast<size_t>(view.image.width_px * view.image.height_px));
            const Stripe stripe = {pixels.data(),
                                   0,
                                   0,
                                   view.image.width_px,
                                   view.image.height_px,
                                   static_cast<uint32_t>(view.image.width_px)};
            const OverColour grey{{1, 1, 1}};
            for (const int32_t span_px : {2, 8, 16}) {
                strays = 0;
                (void)render_spans<Linear, CheckedLuma8, PixelGrey8>(field, camera, grey, stripe, span_px);
                (void)render_spans<Nearest, CheckedLuma8, PixelGrey8>(field, camera, grey, stripe, span_px);
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
    TestLayout layout;
    layout.origins = layout.used_origins = layout.directions = 75;
    layout.texel = TexelFormat::luma8;
    layout.row_stride = 80;
    const Bytes bytes =
        file_of({layout_section(layout), texel_section(layout, [](uint32_t, uint32_t) { return uint8_t{1}; })});
    Field field;
    REQUIRE(open_field(bytes.data(), bytes.size(), field) == FieldError::none);
    const Pose pose = {{-933275, -159750, 484389},
                       {-509756008, 147859956, -933384980},
                       {72855990, -1051212415, -206314655},
                       {942211277, 161279774, -489027624}};
    constexpr int32_t kWidth = 141, kHeight = 34;
    Camera camera;
    REQUIRE(make_camera(pose, {kWidth, kHeight, 1392898754}, camera) == CameraError::none);
    std::vector<uint8_t> pixels(static_cast<size_t>(kWidth) * kHeight);
    const Stripe stripe = {pixels.data(), 0, 0, kWidth, kHeight, kWidth};
    strays = 0;
    (void)render_spans<Linear, CheckedLuma8, PixelGrey8>(field, camera, OverBlack{}, stripe, 16);
    CHECK(strays == 0);
}
