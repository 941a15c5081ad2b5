// SPDX-License-Identifier: MIT
// Views of C and of C++ of the same field and screen. Built with any macros of lumi.h.
#pragma once

#include <catch2/catch.hpp>
#include <memory>
#include <vector>

#include "c/calls.h"
#include "lumi/attitude.h"
#include "lumi/chord/view.h"
#include "lumi/surface/view.h"
#include "surface/see_through_bytes.h"

#ifndef LUMI_C_PIXEL
#define LUMI_C_PIXEL PixelRgb565Swapped
#endif

namespace lumi::test
{

using Pixel = LUMI_C_PIXEL;
inline constexpr int32_t kWidth = 48, kHeight = 37, kRows = 8;
using TestScreen = Screen<kWidth, kHeight, kRows, Pixel>;

using SurfaceView = View<SurfaceDrawing<98, 128, SurfaceMode::two_by_two>, TestScreen>;
using SeeThroughView = View<SurfaceDrawing<98, 128, SurfaceMode::two_by_two, 64>, TestScreen>;
template <class Texel>
using ChordView = View<ChordDrawing<Texel>, TestScreen>;

inline Bytes surface_bytes()
{
    return surface_file(bumpy_ball());
}

inline Bytes see_through_bytes()
{
    return see_through_file(bumpy_ball(), 70);
}

inline Bytes chord_bytes(TexelFormat texel)
{
    return sample_field(layout_of(128, 256, texel));
}

// The field has memory of its own, of the very size that lumi_memory_size tells.
class ViewInC
{
public:
    ViewInC(const Bytes& field, uint8_t mode) : field_(field), screen_{kWidth, kHeight, kRows, mode}
    {
        const size_t bytes = lumi_memory_size(field_.data(), field_.size(), screen_);
        REQUIRE(bytes > 0);
        memory_.resize((bytes + 7) / 8);
        REQUIRE(lumi_open(memory_.data(), bytes, field_.data(), field_.size(), screen_, &view_) == 0);
    }

    lumi_view* get() const { return view_; }
    const lumi_screen& screen() const { return screen_; }

private:
    Bytes field_;
    lumi_screen screen_;
    std::vector<uint64_t> memory_;
    lumi_view* view_ = nullptr;
};

inline lumi_error code(ViewError error)
{
    return static_cast<lumi_error>(error);
}

inline constexpr lumi_quaternion kTurn = {9000, -4000, 11000, 2500};
inline constexpr lumi_colour kColour = {40, 90, 200};

// Pixels of a frame and its coverage, begun with what a stripe may have held before.
struct FrameBytes {
    Bytes pixels, coverage;

    FrameBytes() : coverage(size_t{kWidth} * kHeight, 0x33)
    {
        for (uint32_t k = 0; k < kWidth * kHeight * Pixel::kBytes; ++k)
            pixels.push_back(static_cast<uint8_t>(scattered(k)));
    }
};

template <class AnyView>
ViewError look_in_cpp(AnyView& view, const frame_in_c& f, uint8_t screen_mode)
{
    const lumi_orbit& o = f.orbit;
    const Orbit orbit = {o.azimuth_turns32, o.elevation_turns32, o.distance_q20, o.fov_turns32, o.zoom_q16};
    const uint32_t fov = image_of(orbit, kWidth, kHeight).fov_turns32;
    const auto mode = static_cast<typename AnyView::Mode>(f.eye == EYE_OF_SCREEN ? screen_mode : f.mode);
    switch (f.eye) {
        case EYE_OF_POSE:
            return view.look(pose_of(orbit), fov, mode);
        case EYE_HELD:
            return view.look(held_pose({f.turn.w, f.turn.x, f.turn.y, f.turn.z}, o.distance_q20), fov, mode);
        case EYE_TO_THE_RIGHT:
            return view.look(moved_right(pose_of(orbit), f.offset_q20), fov, mode);
        case EYE_ROLLED:
            return view.look(rolled(pose_of(orbit), 3 * o.azimuth_turns32), fov, mode);
        default:
            return view.look(orbit, mode);
    }
}

template <class AnyView>
ViewError draw_in_cpp(AnyView& view, const frame_in_c& f, const Stripe& stripe)
{
    if (f.background == OVER_COLOUR) return view.draw(stripe, OverColour{{f.colour.r, f.colour.g, f.colour.b}});
    if (f.background == OVER_STRIPE) return view.draw(stripe, OverStripe{});
    if constexpr (std::is_same_v<typename AnyView::Mode, SurfaceMode>)
        if (f.background == OVER_NOTHING) return view.draw(stripe, OverNothing{});
    return view.draw(stripe);
}

template <class AnyView>
void draw_stripe_in_cpp(AnyView& view, const frame_in_c& f, int32_t y, FrameBytes& out)
{
    constexpr uint32_t kStride = kWidth * Pixel::kBytes;
    const int32_t rows = std::min(kRows, kHeight - y);
    const uint32_t at = static_cast<uint32_t>(y);
    REQUIRE(draw_in_cpp(view, f, {out.pixels.data() + at * kStride, 0, y, kWidth, rows, kStride}) == ViewError::none);
    if constexpr (std::is_same_v<typename AnyView::Mode, SurfaceMode>)
        if (f.background == OVER_NOTHING)
            REQUIRE(view.draw_coverage({out.coverage.data() + at * kWidth, 0, y, kWidth, rows, kWidth}) ==
                    ViewError::none);
}

// A view of C and one of C++, of a field of their own.
template <class AnyView>
class Pair
{
public:
    Pair(const Bytes& field, uint8_t mode) : field_(field), c_(field, mode)
    {
        REQUIRE(cpp_->open(field_.data(), field_.size()) == ViewError::none);
    }

    void look(const frame_in_c& f)
    {
        REQUIRE(look_in_c(c_.get(), &f) == 0);
        REQUIRE(look_in_cpp(*cpp_, f, c_.screen().mode) == ViewError::none);
        const lumi_rect by_c = lumi_bounds(c_.get());
        const PixelRect by_cpp = cpp_->bounds();
        CHECK((by_c.x_px == by_cpp.x_px && by_c.y_px == by_cpp.y_px && by_c.width_px == by_cpp.width_px &&
               by_c.height_px == by_cpp.height_px));
        by_c_ = by_cpp_ = FrameBytes();
    }

    void draw_stripe(const frame_in_c& f, int32_t y)
    {
        uint8_t* const coverage = f.background == OVER_NOTHING ? by_c_.coverage.data() : nullptr;
        REQUIRE(draw_stripe_in_c(c_.get(), &f, y, by_c_.pixels.data(), coverage) == 0);
        draw_stripe_in_cpp(*cpp_, f, y, by_cpp_);
    }

    // Draws a whole frame by both.
    void check(const frame_in_c& f)
    {
        look(f);
        for (int32_t y = 0; y < kHeight; y += kRows) draw_stripe(f, y);
        CHECK(are_same());
    }

    bool are_same() const { return by_c_.pixels == by_cpp_.pixels && by_c_.coverage == by_cpp_.coverage; }
    bool draws_anything() const { return by_c_.pixels != FrameBytes().pixels; }
    const lumi_screen& screen() const { return c_.screen(); }
    lumi_view* c() const { return c_.get(); }
    AnyView& cpp() const { return *cpp_; }

private:
    Bytes field_;
    ViewInC c_;
    std::unique_ptr<AnyView> cpp_ = std::make_unique<AnyView>();
    FrameBytes by_c_, by_cpp_;
};

inline frame_in_c frame_of(const lumi_screen& screen, uint8_t mode, int eye, int background, const lumi_orbit& orbit)
{
    return {screen,
            Pixel::kBytes,
            mode,
            static_cast<frame_eye>(eye),
            orbit,
            kTurn,
            LUMI_RADII(1) / 16,
            static_cast<frame_background>(background),
            kColour};
}

}  // namespace lumi::test
