// SPDX-License-Identifier: MIT
// A frame of a chord field, cut into rectangles of any kind: each shows what the whole frame shows in its place.
#include <algorithm>
#include <catch2/catch.hpp>
#include <initializer_list>
#include <random>

#include "chord/drawing.h"

using namespace lumi;
using namespace lumi::test;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr int32_t kSide = 40;
constexpr int kCuts = 2;  // a view and a span's length
#else
constexpr int32_t kSide = 88;
constexpr int kCuts = 12;
#endif

// The stripe holds this before it is drawn over.
uint8_t held(int32_t x, int32_t y, uint32_t byte)
{
    return static_cast<uint8_t>(37 * x + 91 * y + 53 * static_cast<int32_t>(byte));
}

// A rectangle in memory of its very size.
struct Window {
    int32_t x, y, width, height;

    template <class Draw>
    Bytes drawn(uint32_t pixel_bytes, const Draw& draw) const
    {
        const uint32_t stride = static_cast<uint32_t>(width) * pixel_bytes;
        Bytes pixels(stride * static_cast<size_t>(height));
        size_t at = 0;
        for (int32_t row = 0; row < height; ++row)
            for (int32_t column = 0; column < width; ++column)
                for (uint32_t byte = 0; byte < pixel_bytes; ++byte) pixels[at++] = held(x + column, y + row, byte);
        draw(Stripe{pixels.data(), x, y, width, height, stride});
        return pixels;
    }
};

class Windows
{
public:
    explicit Windows(const Image& image) : image_(image) {}

    // In the image, or across its border; mostly narrow.
    Window next()
    {
        Window w{between(-3, image_.width_px - 1), between(-3, image_.height_px - 1), 1, between(1, 20)};
        w.width = between(1, random_() % 2 == 0 ? 20 : image_.width_px);
        return w;
    }

private:
    int32_t between(int32_t low, int32_t high)
    {
        return low + static_cast<int32_t>(random_() % static_cast<uint32_t>(high - low + 1));
    }

    Image image_;
    std::minstd_rand random_{5};
};

// Whether a window's pixels are those of the whole frame; what lies beside the frame is not compared.
bool is_part_of(const Bytes& frame, const Image& image, const Window& w, const Bytes& part, uint32_t pixel_bytes)
{
    for (int32_t row = 0; row < w.height; ++row) {
        for (int32_t column = 0; column < w.width; ++column) {
            const int32_t x = w.x + column, y = w.y + row;
            if (x < 0 || y < 0 || x >= image.width_px || y >= image.height_px) continue;
            const uint8_t* const in_part = part.data() + static_cast<uint32_t>(row * w.width + column) * pixel_bytes;
            const uint8_t* const in_frame = frame.data() + static_cast<uint32_t>(y * image.width_px + x) * pixel_bytes;
            if (!std::equal(in_part, in_part + pixel_bytes, in_frame)) return false;
        }
    }
    return true;
}

struct Cuts {
    uint32_t count = 0, differ = 0;
};

template <class Reconstruction, class Texel, class Pixel, class Background>
Cuts cut(const Field& field, const View& view, const Background& background, int32_t span_px)
{
    const Camera camera = camera_of(view);
    const auto draw = [&](const Stripe& stripe) {
        REQUIRE(draw_chord<Reconstruction, Texel, Pixel>(field, camera, background, stripe, span_px) ==
                RenderError::none);
    };
    const Bytes frame = Window{0, 0, view.image.width_px, view.image.height_px}.drawn(Pixel::kBytes, draw);
    Windows windows(view.image);
    Cuts cuts;
    for (int k = 0; k < kCuts; ++k, ++cuts.count) {
        const Window window = windows.next();
        const Bytes part = window.drawn(Pixel::kBytes, draw);
        if (!is_part_of(frame, view.image, window, part, Pixel::kBytes)) ++cuts.differ;
    }
    return cuts;
}

template <class Reconstruction, class Texel, class Pixel, class Background>
void check_cuts(const TestLayout& layout, const Background& background,
                std::initializer_list<int32_t> spans = {2, 4, 8, 16})
{
    const OpenField open(sample_field(layout));
    for (const int32_t span_px : spans) {
        for (const View& view : extreme_views(kSide)) {
            const Cuts cuts = cut<Reconstruction, Texel, Pixel>(open.field, view, background, span_px);
            INFO(view.name << ", spans of " << span_px << ", " << cuts.count << " cuts");
            CHECK(cuts.differ == 0);
        }
    }
}

}  // namespace

TEST_CASE("spans cut into rectangles of any shape show the pixels of the whole frame", "[span]")
{
    const TestLayout plain = layout_of(300, 700, TexelFormat::rgb565);
    const TestLayout capped = layout_of(400, 350, TexelFormat::palette8, 210);
    check_cuts<Linear, TexelRgb565, PixelRgb565>(plain, OverBlack{});
    check_cuts<Linear, TexelPalette8, PixelRgb888>(capped, OverStripe{});
    check_cuts<Nearest, TexelRgb565, PixelRgb565>(plain, OverColour{{9, 8, 7}});
    check_cuts<Nearest, TexelPalette8, PixelRgb565Swapped>(capped, OverBlack{});
    check_cuts<Linear, TexelPalette8, PixelArgb8888>(capped, OverBlack{});
    check_cuts<Nearest, TexelRgb565, PixelGrey8>(plain, OverBlack{});
}

TEST_CASE("exactly drawn frames cut into rectangles of any shape show the pixels of the whole frame", "[render]")
{
    check_cuts<Nearest, TexelRgb565, PixelRgb565>(layout_of(100, 120, TexelFormat::rgb565, 70), OverBlack{}, {0});
}
