// SPDX-License-Identifier: MIT
// Views of C and of C++ of the same field and screen. Built with any macros of lumi.h.
#pragma once

#include <catch2/catch.hpp>
#include <memory>
#include <vector>

#include "c/calls.h"
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

}  // namespace lumi::test
