// SPDX-License-Identifier: MIT
// Runs every block of docs/firmware.md and compares what it draws with frames of plain views.
#include <stdio.h>
#include <stdlib.h>

#include <vector>

#include "product.h"
using namespace lumi;

static product_view<Screen<240, 240, 16>> view;

#include "PixelRgb666.h"
#include "draw_both.h"
#include "open_slot.h"

namespace
{

constexpr Orbit kOrbit = {degrees(30), degrees(20), radii(3)};
using Frame = std::vector<uint8_t>;

void must(bool is_so, const char* what)
{
    if (is_so) return;
    fprintf(stderr, "docs/firmware.md: %s\n", what);
    exit(1);
}

void must(ViewError error, const char* what)
{
    must(error == ViewError::none, what);
}

// A frame by stripes of 16 rows over black.
template <class Pixel, class Draw>
Frame frame_by(Draw draw)
{
    constexpr uint32_t kStride = 240 * Pixel::kBytes;
    Frame frame(240 * kStride);
    for (int32_t y = 0; y < 240; y += 16)
        must(draw({frame.data() + static_cast<uint32_t>(y) * kStride, 0, y, 240, 16, kStride}), "a stripe");
    return frame;
}

template <class Pixel = PixelRgb565Swapped, class Of>
Frame frame_of(Of& any)
{
    return frame_by<Pixel>([&](const Stripe& stripe) { return any.draw(stripe); });
}

// A panel: what it shows.
struct Panel565 {
    PixelRect window;
    Frame shown = Frame(240 * 240 * 2, 0xA5);
    uint64_t sent = 0;
} panel;

void panel_window(int32_t x, int32_t y, int32_t width, int32_t height)
{
    must((x | y | width | height) % 2 == 0, "a window has odd sides");
    panel.window = {x, y, width, height};
}

void panel_write(const uint8_t* pixels, uint32_t bytes)
{
    const PixelRect& w = panel.window;
    must(bytes == static_cast<uint32_t>(w.width_px * w.height_px * 2), "a window is not filled");
    for (uint32_t k = 0; k < bytes; ++k) {
        const uint32_t row = k / static_cast<uint32_t>(w.width_px * 2),
                       column = k % static_cast<uint32_t>(w.width_px * 2);
        panel.shown[(static_cast<uint32_t>(w.y_px) + row) * 480 + static_cast<uint32_t>(w.x_px) * 2 + column] =
            pixels[k];
    }
    panel.sent += bytes;
}

}  // namespace

#include "send_changes.h"

namespace
{

void draws_two_views_with_one_memory()
{
    static product_view<Screen<240, 240, 16>> behind, before;
    const Orbit other = {degrees(200), degrees(40), radii(3), kFitSphere, kNoZoom / 2};
    must(left.open(product, product_size()), "left");
    must(right.open(product, product_size()), "right");
    must(behind.open(product, product_size()), "behind");
    must(before.open(product, product_size()), "before");
    for (auto* any : {&behind}) must(any->look(kOrbit), "look");
    must(left.look(kOrbit), "look");
    must(right.look(other), "look");
    must(before.look(other), "look");
    const auto shared = frame_by<PixelRgb565Swapped>([](const Stripe& stripe) { return draw_both(stripe, stripe); });
    const auto own = frame_by<PixelRgb565Swapped>([](const Stripe& stripe) {
        must(behind.draw(stripe), "a stripe");
        return before.draw(stripe, OverStripe{});
    });
    must(shared == own, "views that share samples draw something else");
    must(own != frame_of(behind), "the second view shows nothing");
}

void opens_the_last_field_where_the_newest_is_damaged()
{
    const Frame whole(product, product + product_size());
    Frame part = whole;
    for (size_t k = part.size() * 3 / 4; k < part.size(); ++k) part[k] = 0xFF;
    const Slot last = {product, product_size()};
    must(open_slot({part.data(), part.size()}) != ViewError::none, "a slot that was written in part opens");
    must(open_newest({part.data(), part.size()}, last), "the last slot does not open");
    must(open_newest({whole.data(), whole.size() / 2}, last), "the last slot does not open");
    must(grown.look(kOrbit), "look");
    must(view.open(product, product_size()), "open");
    must(view.look(kOrbit, SurfaceMode::antialiased), "look");
    must(frame_of(grown) == frame_of(view), "a view of a stated capacity draws something else");
    must(open_newest({whole.data(), whole.size()}, {nullptr, 0}), "the newest slot does not open");
}

void sends_even_windows()
{
    for (const uint32_t zoom : {kNoZoom, kNoZoom / 3, kNoZoom / 4, kNoZoom / 2}) {
        must(send_changes({degrees(30), degrees(20), radii(3), kFitSphere, zoom}), "send_changes");
        must(panel.shown == frame_of(view), "the panel does not show the frame");
    }
    must(panel.sent < 3 * panel.shown.size(), "windows save nothing");
}

void rounds_to_six_bits()
{
    static product_view<Screen<240, 240, 16, PixelRgb666>> six;
    static product_view<Screen<240, 240, 16, PixelRgb888>> eight;
    must(six.open(product, product_size()), "open");
    must(eight.open(product, product_size()), "open");
    must(six.look(kOrbit), "look");
    must(eight.look(kOrbit), "look");
    Frame expected = frame_of<PixelRgb888>(eight);
    uint32_t changed = 0;
    for (uint8_t& value : expected) {
        const uint8_t rounded = PixelRgb666::rounded(value);
        must(abs(rounded - value) <= 4 && rounded % 4 == 0, "a colour is not rounded to six bits");
        changed += rounded != value;
        value = rounded;
    }
    must(changed > 1000, "no colour needed rounding");
    must(frame_of<PixelRgb666>(six) == expected, "pixels of six bits are others");
}

}  // namespace

int main()
{
    draws_two_views_with_one_memory();
    opens_the_last_field_where_the_newest_is_damaged();
    sends_even_windows();
    rounds_to_six_bits();
    return 0;
}
