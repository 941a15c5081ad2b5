// SPDX-License-Identifier: MIT
// Screens of one and a few pixels: their margins are larger than they are.
#include <catch2/catch.hpp>
#include <memory>

#include "lumi/lumi.h"
#include "lumi/surface/view.h"
#include "surface/surface_bytes.h"
#include "surface/surface_drawing.h"

using namespace lumi;
using test::Bytes;

namespace
{

constexpr Orbit kOrbit = {degrees(30), degrees(-20), radii(5) / 2};
constexpr SurfaceMode kModes[] = {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two};

const Bytes& ball()
{
    static const Bytes bytes = test::surface_file(test::bumpy_ball());
    return bytes;
}

// A whole image by one stripe, without a view, in bands of one scanline: no picture depends on their height.
Bytes free_image(const Image& image, SurfaceMode mode)
{
    SurfaceField field;
    REQUIRE(open_surface(ball().data(), ball().size(), field) == FieldError::none);
    return test::drawn<PixelRgb888, SurfaceFeatures::view_tables>(field, {"", pose_of(kOrbit), image}, mode,
                                                                  OverBlack{}, {}, 0)
        .pixels();
}

// Every mode up to the finest in stripes of kRows, with samples in memory of their very size.
template <int32_t kWidth, int32_t kHeight, int32_t kRows, SurfaceMode kFinest>
void check_modes()
{
    using Small = Screen<kWidth, kHeight, kRows, PixelRgb888>;
    using SmallView = View<SurfaceDrawing<98, 128, kFinest>, Small>;
    const auto view = std::make_unique<SmallView>();
    const auto samples = std::make_unique<typename SmallView::Samples>();
    REQUIRE(view->open(ball().data(), ball().size()) == ViewError::none);
    for (const SurfaceMode mode : kModes) {
        INFO(kWidth << " x " << kHeight << ", " << kRows << " rows, mode " << static_cast<int>(mode) << " of "
                    << static_cast<int>(kFinest));
        const ViewError looked = view->look(kOrbit, mode);
        CHECK(looked == (mode > kFinest ? ViewError::mode_too_fine : ViewError::none));
        if (looked != ViewError::none) continue;
        const uint32_t stride = 3 * kWidth;
        Bytes pixels(stride * kHeight, 0xA5);
        for (int32_t y = 0; y < kHeight; y += kRows) {
            const int32_t rows = kHeight - y < kRows ? kHeight - y : kRows;
            const Stripe stripe = {pixels.data() + static_cast<uint32_t>(y) * stride, 0, y, kWidth, rows, stride};
            CHECK(view->draw(stripe, OverBlack{}, *samples) == ViewError::none);
        }
        CHECK((pixels == free_image(image_of(kOrbit, kWidth, kHeight), mode)));
    }
}

template <int32_t kWidth, int32_t kHeight>
void check_screen()
{
    check_modes<kWidth, kHeight, 1, SurfaceMode::one_sample>();
    check_modes<kWidth, kHeight, 1, SurfaceMode::antialiased>();
    check_modes<kWidth, kHeight, 1, SurfaceMode::two_by_two>();
    check_modes<kWidth, kHeight, kHeight, SurfaceMode::antialiased>();
    check_modes<kWidth, kHeight, kHeight, SurfaceMode::two_by_two>();
}

}  // namespace

TEST_CASE("screens of any size, of a single pixel, too, are drawn in every mode up to the finest")
{
    check_screen<1, 1>();
    check_screen<1, 2>();
    check_screen<2, 1>();
    check_screen<2, 2>();
    check_screen<1, 5>();
    check_screen<5, 1>();
    check_screen<1, 6>();
    check_screen<6, 1>();
    check_screen<3, 2>();
    check_screen<1, 31>();
    check_screen<31, 1>();
}

TEST_CASE("screens of a single pixel, row or column are drawn in every mode from C, with no more memory than it tells")
{
    constexpr int32_t kSizes[][2] = {{1, 1}, {1, 2}, {2, 1}, {2, 2}, {1, 5}, {5, 1}, {1, 31}, {31, 1}};
    for (const auto& size : kSizes) {
        for (const SurfaceMode mode : kModes) {
            const lumi_screen screen = {size[0], size[1], 1, static_cast<uint8_t>(mode)};
            const size_t bytes = lumi_memory_size(ball().data(), ball().size(), screen);
            std::vector<uint64_t> memory(bytes / 8 + 1);
            lumi_view* view = nullptr;
            INFO(size[0] << " x " << size[1] << ", mode " << static_cast<int>(mode));
            REQUIRE(lumi_open(memory.data(), bytes, ball().data(), ball().size(), screen, &view) == 0);
            REQUIRE(lumi_look(view, {kOrbit.azimuth_turns32, kOrbit.elevation_turns32, kOrbit.distance_q20, 0, 0}) ==
                    0);
            std::vector<uint16_t> pixels(static_cast<size_t>(size[0]));
            const uint32_t stride = 2 * static_cast<uint32_t>(size[0]);
            for (int32_t y = 0; y < size[1]; ++y)
                CHECK(lumi_draw(view, {reinterpret_cast<uint8_t*>(pixels.data()), 0, y, size[0], 1, stride}) == 0);
        }
    }
}
