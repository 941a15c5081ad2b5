// SPDX-License-Identifier: MIT
#include "halves.h"

#include "lumi/surface/view.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr uint32_t kFields = 6;
#else
constexpr uint32_t kFields = 60;
#endif

constexpr int32_t kSide = 64;
constexpr Orbit kOrbit = {lumi::degrees(40), lumi::degrees(25), radii(3)};
using HalvedView = lumi::View<SurfaceDrawing<98, 128>, Screen<kSide, kSide, 16>>;

struct HalvedFrame {
    std::vector<uint32_t> pixels = std::vector<uint32_t>(kSide * kSide / 2);

    explicit HalvedFrame(HalvedView& view)
    {
        uint8_t* const bytes = reinterpret_cast<uint8_t*>(pixels.data());
        for (int32_t y = 0; y < kSide; y += 16)
            REQUIRE(view.draw({bytes + y * kSide * 2, 0, y, kSide, 16, kSide * 2}) == ViewError::none);
    }
};

}  // namespace

TEST_CASE("two halves prepare the frame of one core, in either order")
{
    check_many_halves(kFields, [](SurfaceHalves& halves, int32_t step) {
        prepare_half(halves, step, 0);
        prepare_half(halves, step, 1);
    });
    check_many_halves(kFields / 3, [](SurfaceHalves& halves, int32_t step) {
        prepare_half(halves, step, 1);
        prepare_half(halves, step, 0);
    });
}

TEST_CASE("a view is prepared by halves in every mode, and by one core again")
{
    static HalvedView view;
    static HalvedView::Halves halves;
    const Bytes bytes = surface_file(bumpy_ball());
    const auto both = [](int32_t step) {
        halves.prepare(step, 1);
        halves.prepare(step, 0);
    };
    CHECK(view.look(kOrbit, halves, both) == ViewError::no_field);
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    CHECK(view.look(kOrbit, halves, both, SurfaceMode::two_by_two) == ViewError::mode_too_fine);
    CHECK(view.look(Orbit{0, 0, radii(0)}, halves, both) == view_error(CameraError::eye_inside_sphere));
    for (const SurfaceMode mode : {SurfaceMode::one_sample, SurfaceMode::antialiased}) {
        REQUIRE(view.look(kOrbit, mode) == ViewError::none);
        const HalvedFrame by_one(view);
        REQUIRE(view.look(Orbit{0, 0, radii(2)}, halves, both, mode) == ViewError::none);
        REQUIRE(view.look(kOrbit, halves, both, mode) == ViewError::none);
        CHECK((HalvedFrame(view).pixels == by_one.pixels));
        REQUIRE(view.look(kOrbit, mode) == ViewError::none);
        CHECK((HalvedFrame(view).pixels == by_one.pixels));
    }
}

TEST_CASE("a half that does not run leaves a wrong picture and the next frame as it should be")
{
    static HalvedView view;
    static HalvedView::Halves halves;
    const Bytes bytes = surface_file(bumpy_ball());
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    const auto look = [&](const Orbit& orbit, uint32_t missing) {
        return view.look(orbit, halves, [&](int32_t step) {
            for (uint32_t half = 0; half < 2; ++half)
                if ((missing >> (2 * static_cast<uint32_t>(step) + half) & 1) == 0) halves.prepare(step, half);
        });
    };
    REQUIRE(view.look(kOrbit) == ViewError::none);
    const HalvedFrame right(view);
    for (uint32_t missing = 0; missing < 64; ++missing) {
        REQUIRE(look(Orbit{missing << 26, 0, radii(1) + (1 << 17)}, missing) == ViewError::none);
        const HalvedFrame some(view);  // no wild read
        REQUIRE(look(kOrbit, 0) == ViewError::none);
        REQUIRE((HalvedFrame(view).pixels == right.pixels));
    }
}

TEST_CASE("the first half places the first vertices, which its patches begin with, and the second one the others")
{
    const OpenedSurface sheet(surface_file(wavy_sheet()));
    constexpr int32_t kHeight = 96;
    SurfaceCamera camera;
    REQUIRE(make_surface_camera(pose_of(kOrbit), {kHeight, kHeight, lumi::degrees(50), 0, 0}, camera) ==
            CameraError::none);
    const uint32_t count = sheet.field().vertex_count, middle = count / 2;
    for (uint32_t half = 0; half < 2; ++half) {
        PreparedFrame memory(sheet.field(), kHeight, 4);
        constexpr uint32_t kOld = 0xA5A5A5A5;
        for (SurfaceVertex& v : memory.vertices) v.colour = kOld;
        std::vector<uint16_t> bands(memory.bands.size());
        SurfaceHalves halves{};
        halves.bands = bands.data();
        REQUIRE(begin_halves(sheet.field(), camera, SurfaceMode::one_sample, memory.memory, memory.frame, halves));
        run_half(halves, kPlaceVertices, half);
        for (uint32_t k = 0; k < count; ++k) {
            INFO("half " << half << ", vertex " << k << " of " << count);
            REQUIRE((memory.vertices[k].colour != kOld) == (k < middle ? half == 0 : half == 1));
        }
    }
}

TEST_CASE("a step that does not exist prepares nothing")
{
    static HalvedView view;
    static HalvedView::Halves halves;
    const Bytes bytes = surface_file(bumpy_ball());
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    REQUIRE(view.look(kOrbit) == ViewError::none);
    const HalvedFrame right(view);
    REQUIRE(view.look(kOrbit, halves, [&](int32_t step) {
        for (const int32_t none : std::initializer_list<int32_t>{INT32_MIN, -1, 3, INT32_MAX})
            halves.prepare(none, 0), halves.prepare(none, 1);
        halves.prepare(step, 0), halves.prepare(step, 1);
    }) == ViewError::none);
    CHECK((HalvedFrame(view).pixels == right.pixels));
}

TEST_CASE("halves of a frame that looks away from the object need not run, and it is background")
{
    static HalvedView view;
    static HalvedView::Halves halves;
    const Bytes bytes = surface_file(bumpy_ball());
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    lumi::Pose away = pose_of(kOrbit);
    const auto turned = [](const Vec3q30& v) { return Vec3q30{-v.x, -v.y, -v.z}; };
    away.forward = turned(away.forward), away.right = turned(away.right);
    uint32_t steps = 0;
    REQUIRE(view.look(away, lumi::degrees(50), halves, [&](int32_t) { ++steps; }) == ViewError::none);
    CHECK(steps == 0);
    CHECK((HalvedFrame(view).pixels == HalvedFrame(view).pixels));
    for (const uint32_t two : HalvedFrame(view).pixels) REQUIRE(two == 0);
}

TEST_CASE("bands are of 16 scanlines at least, and no higher than stripes")
{
    struct {
        int32_t rows;
        uint32_t log2;
    } const kBands[] = {{1, 4},  {8, 4},  {15, 4}, {16, 4},  {17, 3},  {24, 3},  {31, 3},
                        {32, 5}, {48, 4}, {64, 6}, {256, 8}, {257, 7}, {512, 8}, {8192, 8}};
    for (const auto& band : kBands) {
        INFO(band.rows << " scanlines");
        CHECK(surface_band_log2(band.rows) == band.log2);
    }
}
