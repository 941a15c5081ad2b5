// SPDX-License-Identifier: MIT
// A view draws a field on a display by three calls, with all memory inside one object:
//
//     #include "product.h"                                     // `lumi embed` wrote it: product_view, product
//     static product_view<Screen<240, 240, 16>> view;          // static: its size is the RAM of a frame
//     view.open(product, product_size());                      // once
//     view.look(Orbit{degrees(30), degrees(20), radii(3)});    // each frame
//     view.draw({pixels, 0, y, 240, 16, 480});                 // each stripe
//
// Every call returns a ViewError (view_error.h) and checks what it is given. The pixels are those of the free functions
// (surface/render.h, chord/render_spans.h), which a view calls and which stay. Their rules hold: stripes in any order
// and of any shape. A surface field's stripe may have, within the image, no more pixels than the screen's stripe, which
// is kRows rows of the image; `antialiased` counts both with a margin of one pixel all around.
#pragma once
#pragma GCC system_header

#include "lumi/background.h"
#include "lumi/color.h"
#include "lumi/orbit.h"
#include "lumi/pixel.h"
#include "lumi/stripe.h"
#include "lumi/view_error.h"

namespace lumi::detail
{

// An image has this size, or the part of a stripe that lies in it.
struct PixelSize {
    int32_t width_px, height_px;
};

}  // namespace lumi::detail

namespace lumi
{

// This is an image of width × height pixels, drawn at most kRows rows at once. The default pixels are those of SPI
// panels.
template <int32_t kWidth = 240, int32_t kHeight = 240, int32_t kRows = 16, class PixelFormat = PixelRgb565Swapped>
struct Screen {
    static_assert(kWidth >= 1 && kWidth <= kMaxImageSide && kHeight >= 1 && kHeight <= kMaxImageSide,
                  "an image has 1 to 8192 pixels a side");
    static_assert(kRows >= 1, "a stripe has rows");
    using Pixel = PixelFormat;
    static constexpr int32_t kWidthPx = kWidth;
    static constexpr int32_t kHeightPx = kHeight;
    static constexpr int32_t kRowsPx = kRows < kHeight ? kRows : kHeight;
    static constexpr uint32_t kStripeBytes = static_cast<uint32_t>(kWidthPx * kRowsPx) * Pixel::kBytes;
    static constexpr bool kHasSamples = true;

    template <class State>
    static constexpr detail::PixelSize size_of(const State&)
    {
        return {kWidthPx, kHeightPx};
    }
};

// A view on this screen has no memory for samples of its own: several views that draw in turn share one.
//
//     using Panel = SharedSamples<Screen<240, 240, 16>>;
//     static clock_view<Panel> clock;
//     static watch_view<Panel> watch;
//     static SamplesFor<decltype(clock), decltype(watch)> samples;
//     clock.draw(stripe, OverBlack{}, samples);
//
// From another draw() on, the samples are of that stripe: draw_coverage() comes before it.
template <class ScreenOf>
struct SharedSamples : ScreenOf {
    static constexpr bool kHasSamples = false;
};

}  // namespace lumi

namespace lumi::detail
{

// Holds a view's own memory for samples, or none.
template <class Samples, bool kHas>
struct OwnSamples {
    Samples samples{};
};
template <class Samples>
struct OwnSamples<Samples, false> {
};

// Holds so many bytes of samples.
template <uint32_t kBytesOf>
struct SampleMemory {
    static constexpr uint32_t kBytes = kBytesOf;
    uint32_t words[(kBytes + 3) / 4] = {};

    uint32_t* data() { return words; }
};
template <>
struct SampleMemory<0> {
    static constexpr uint32_t kBytes = 0;

    uint32_t* data() { return nullptr; }
};

constexpr uint32_t most_of(uint32_t only)
{
    return only;
}
template <class... More>
constexpr uint32_t most_of(uint32_t first, More... more)
{
    return first > most_of(more...) ? first : most_of(more...);
}

// Finds every fault of a stripe but its size. Fills `out` with the part that lies in the image: nothing where a side is
// 0.
ViewError check_stripe(const Stripe& stripe, const PixelSize& image, uint32_t pixel_bytes, PixelSize& out);

}  // namespace lumi::detail

namespace lumi
{

// `Drawing` is SurfaceDrawing (surface/view.h) or ChordDrawing (chord/view.h). `lumi embed` names the one of a field.
template <class Drawing, class ScreenOf = Screen<>>
class View
{
public:
    using Pixel = typename ScreenOf::Pixel;
    using Mode = typename Drawing::Mode;
    // Counts the bytes of the highest stripe.
    static constexpr uint32_t kStripeBytes = ScreenOf::kStripeBytes;
    // A stripe takes this memory for samples. The view has one; a second core brings its own, and so does each core
    // where the screen is SharedSamples.
    using Samples = typename Drawing::template Samples<ScreenOf>;
    // Two cores share it while they prepare a frame. One core needs none.
    using Halves = typename Drawing::template Halves<ScreenOf>;

    constexpr View() = default;
    View(const View&) = delete;  // parts of it point to each other
    View& operator=(const View&) = delete;

    // Reads nothing of the field into RAM; its bytes stay where they are as long as the view is used. Checks all that
    // decides where bytes are read. After a failure the view has no field.
    ViewError open(const uint8_t* bytes, size_t size)
    {
        bytes_ = nullptr;
        has_look_ = false;
        const ViewError error = bytes == nullptr ? ViewError::bad_argument : state_.open(bytes, size);
        if (error != ViewError::none) return error;
        bytes_ = bytes;
        size_ = size;
        return ViewError::none;
    }

    // Compares every byte with the checksums that were written with it: tells damaged flash from flash as it was
    // written. Reads the whole field once.
    ViewError verify() const
    {
        return bytes_ == nullptr ? ViewError::no_field : detail::view_error(verify_field(bytes_, size_));
    }

    // Sets the next frame's eye. A failure leaves the frame as it was.
    ViewError look(const Orbit& orbit, Mode mode = Drawing::kDefaultMode)
    {
        return look(pose_of(orbit), fov_of(orbit), mode);
    }
    ViewError look(const Pose& pose, uint32_t fov_turns32, Mode mode = Drawing::kDefaultMode)
    {
        if (bytes_ == nullptr) return ViewError::no_field;
        return looked(state_.look(pose, image_with(fov_turns32), mode));
    }

    // Two cores prepare the frame. `both(step)` lets halves.prepare(step, 0) and halves.prepare(step, 1) run
    // once each, at once or in turn, and comes back after both; surface/halves.h says what it must guarantee. Chord
    // fields have nothing to prepare and do not call it.
    template <class Both>
    ViewError look(const Orbit& orbit, Halves& halves, const Both& both, Mode mode = Drawing::kDefaultMode)
    {
        return look(pose_of(orbit), fov_of(orbit), halves, both, mode);
    }
    template <class Both>
    ViewError look(const Pose& pose, uint32_t fov_turns32, Halves& halves, const Both& both,
                   Mode mode = Drawing::kDefaultMode)
    {
        if (bytes_ == nullptr) return ViewError::no_field;
        return looked(state_.look(pose, image_with(fov_turns32), mode, halves, both));
    }

    // Returns the field of view that look() takes for an orbit: fitted to the sphere, and zoomed.
    uint32_t fov_of(const Orbit& orbit) const
    {
        const detail::PixelSize size = ScreenOf::size_of(state_);
        return image_of(orbit, size.width_px, size.height_px).fov_turns32;
    }

    // Tells where the object is in this frame: beside it, every pixel is background. What a display must be sent is
    // this rectangle and the last frame's. Empty before a look. Free for surface fields; for chord fields it finds the
    // sphere's outline in every scanline.
    PixelRect bounds() const { return has_look_ ? state_.bounds() : PixelRect{0, 0, 0, 0}; }

    // Turns or slides a moving part of a surface field (surface/parts.h) from the next look() on: to an angle,
    // right-handed about its axis, or to an offset along it in radii. `lumi embed` names the parts. Values beyond the
    // part's range are its nearer end. bad_argument: no such part, or one that moves in the other way.
    ViewError turn(uint32_t part, uint32_t turns32)
    {
        return bytes_ == nullptr ? ViewError::no_field : state_.turn(part, turns32);
    }
    ViewError slide(uint32_t part, int32_t offset_q20)
    {
        return bytes_ == nullptr ? ViewError::no_field : state_.slide(part, offset_q20);
    }

    // Weighs a light state of a surface field (surface/states.h) from the next look() on: each channel of its light, or
    // all of them alike. `lumi embed` names the states. bad_argument: no such state.
    ViewError set_state(uint32_t state, const StateWeight& weight)
    {
        return bytes_ == nullptr ? ViewError::no_field : state_.set_state(state, weight);
    }
    ViewError set_state(uint32_t state, uint32_t weight_q12)
    {
        const uint16_t weight = static_cast<uint16_t>(weight_q12 < kFullWeight ? weight_q12 : kFullWeight);
        return set_state(state, StateWeight{weight, weight, weight});
    }

    // Tells at most four rectangles beside which the last look() changed no pixel. Their sides are multiples of `align`
    // as far as the image reaches. Only parts have moved: each rectangle is about them; else it is where either frame
    // shows anything, and at the first look the image.
    auto changed(uint32_t align_x = 1, uint32_t align_y = 1) const
    {
        using Changed = decltype(state_.changed(align_x, align_y));
        return has_look_ ? state_.changed(align_x, align_y) : Changed{};
    }

    // Returns the most rows that a surface field's stripe of this width may have in the mode of the last look(): with
    // the pixels of the screen's stripe, and its memory. Narrow rectangles are drawn fastest in few stripes. 1 <=
    // width_px
    // <= the image's.
    int32_t rows_at(int32_t width_px) const { return state_.rows_at(width_px); }

    // Draws every pixel of the stripe over black, or over another background (background.h), which also fills what of
    // the stripe lies beside the image.
    ViewError draw(const Stripe& stripe) { return draw(stripe, OverBlack{}); }
    template <class Background>
    ViewError draw(const Stripe& stripe, const Background& background)
    {
        static_assert(ScreenOf::kHasSamples, "a view of SharedSamples draws with the samples that it is given");
        return draw(stripe, background, own_.samples);
    }
    // Draws with other samples, those of this view or larger ones: from several cores at once, each with its own.
    template <class Background, class SamplesOf>
    ViewError draw(const Stripe& stripe, const Background& background, SamplesOf& samples) const
    {
        static_assert(SamplesOf::kBytes >= Samples::kBytes, "the samples are too few for this view: see SamplesFor");
        if (!has_look_) return bytes_ == nullptr ? ViewError::no_field : ViewError::no_look;
        detail::PixelSize part = {};
        const ViewError error = detail::check_stripe(stripe, ScreenOf::size_of(state_), Pixel::kBytes, part);
        return error == ViewError::none ? state_.draw(stripe, part, background, samples.data()) : error;
    }

    // Stores a surface field's coverage of the stripe that was drawn last over OverNothing, a byte a pixel: see
    // render_coverage.
    ViewError draw_coverage(const Stripe& coverage)
    {
        static_assert(ScreenOf::kHasSamples, "a view of SharedSamples draws with the samples that it is given");
        return draw_coverage(coverage, own_.samples);
    }
    template <class SamplesOf>
    ViewError draw_coverage(const Stripe& coverage, SamplesOf& samples) const
    {
        static_assert(SamplesOf::kBytes >= Samples::kBytes, "the samples are too few for this view: see SamplesFor");
        if (!has_look_) return bytes_ == nullptr ? ViewError::no_field : ViewError::no_look;
        detail::PixelSize part = {};
        const ViewError error = detail::check_stripe(coverage, ScreenOf::size_of(state_), 1, part);
        return error == ViewError::none ? state_.draw_coverage(coverage, part, samples.data()) : error;
    }

private:
    Image image_with(uint32_t fov_turns32) const
    {
        const detail::PixelSize size = ScreenOf::size_of(state_);
        return {size.width_px, size.height_px, fov_turns32};
    }

    ViewError looked(ViewError error)
    {
        if (error == ViewError::none) has_look_ = true;
        return error;
    }

protected:  // a lumi_view (src/c/view.h) opens its field by itself
    typename Drawing::template State<ScreenOf> state_{};
    detail::OwnSamples<Samples, ScreenOf::kHasSamples> own_{};
    const uint8_t* bytes_ = nullptr;
    size_t size_ = 0;
    bool has_look_ = false;
};

// Holds samples for a stripe of each of these views, drawn in turn.
template <class... Views>
using SamplesFor = detail::SampleMemory<detail::most_of(Views::Samples::kBytes...)>;

}  // namespace lumi
