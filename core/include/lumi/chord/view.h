// SPDX-License-Identifier: MIT
// A view of a chord field (view.h) needs no memory besides the stripe.
#pragma once
#pragma GCC system_header

#include "lumi/chord/render_spans.h"
#include "lumi/view.h"

namespace lumi::detail
{

// Opens a field with texels of one of these formats, for render_spans() or for render(). `out` stays as it was on
// failure.
template <bool kBySpans, class... Texels>
ViewError open_chord(const uint8_t* bytes, size_t size, Field& out)
{
    Field opened;
    if (const FieldError error = open_field(bytes, size, opened); error != FieldError::none) return view_error(error);
    if (((opened.texel_format != Texels::kFormat) && ...)) return ViewError::other_renderer;
    if (kBySpans && !fits_spans(opened)) {
        const bool is_aligned = reinterpret_cast<uintptr_t>(bytes) % 4 == 0;
        return is_aligned ? ViewError::other_renderer : ViewError::unaligned_field;
    }
    out = opened;
    return ViewError::none;
}

// The spans that render_spans() tells apart.
constexpr bool is_span(int32_t px)
{
    return px == 2 || px == 4 || px == 8 || px == 16;
}

// Nothing of a frame is prepared that two cores could share.
struct NoHalves {
    void prepare(int32_t, uint32_t) {}
};

// Holds a view's field and camera and draws by spans fields with texels of one of these formats.
template <class Reconstruction, class Pixel, class... Texels>
class SpansState
{
public:
    ViewError open(const uint8_t* bytes, size_t size) { return open_chord<true, Texels...>(bytes, size, field_); }

    template <class... Halves>
    ViewError look(const Pose& pose, const Image& image, int32_t span_px, const Halves&...)
    {
        if (!is_span(span_px)) return ViewError::wrong_span;
        const ViewError error = view_error(make_camera(pose, image, camera_));
        if (error == ViewError::none) span_px_ = span_px;
        return error;
    }

    PixelRect bounds() const { return covered_rectangle(camera_); }

    template <class Background>
    ViewError draw(const Stripe& stripe, const PixelSize&, const Background& background, uint32_t*) const
    {
        const RenderError error = with_texel(
            field_.texel_format,
            [&](auto texel) {
                return render_spans<Reconstruction, decltype(texel), Pixel>(field_, camera_, background, stripe,
                                                                            span_px_);
            },
            TexelList<Texels...>());
        return error == RenderError::none ? ViewError::none : ViewError::other_renderer;
    }

protected:
    Field field_{};

private:
    Camera camera_{};
    int32_t span_px_ = 0;
};

}  // namespace lumi::detail

namespace lumi
{

// Draws by spans, render_spans(). The mode is how many pixels may lie between exact hits: 2, 4, 8 or 16; any other is
// wrong_span.
template <class Texel, class Reconstruction = Linear>
struct ChordDrawing {
    using Mode = int32_t;
    static constexpr Mode kDefaultMode = 16;

    template <class>
    using Samples = detail::SampleMemory<0>;
    template <class>
    using Halves = detail::NoHalves;

    template <class ScreenOf>
    using State = detail::SpansState<Reconstruction, typename ScreenOf::Pixel, Texel>;
};

// Draws every pixel by itself, render(): for fields that spans do not draw, at any address.
template <class Texel, class Reconstruction = Linear>
struct ExactChordDrawing {
    struct Mode {
    };
    static constexpr Mode kDefaultMode = {};

    template <class>
    using Samples = detail::SampleMemory<0>;
    template <class>
    using Halves = detail::NoHalves;

    template <class ScreenOf>
    class State
    {
    public:
        ViewError open(const uint8_t* bytes, size_t size)
        {
            return detail::open_chord<false, Texel>(bytes, size, field_);
        }
        template <class... Halves>
        ViewError look(const Pose& pose, const Image& image, Mode, const Halves&...)
        {
            return detail::view_error(make_camera(pose, image, camera_));
        }

        PixelRect bounds() const { return detail::covered_rectangle(camera_); }

        template <class Background>
        ViewError draw(const Stripe& stripe, const detail::PixelSize&, const Background& background, uint32_t*) const
        {
            const RenderError error =
                render<Reconstruction, Texel, typename ScreenOf::Pixel>(field_, camera_, background, stripe);
            return error == RenderError::none ? ViewError::none : ViewError::other_renderer;
        }

    private:
        Field field_{};
        Camera camera_{};
    };
};

}  // namespace lumi
