// SPDX-License-Identifier: MIT
// A view of a chord field (view.h). Besides the stripe it needs no memory.
#pragma once
#pragma GCC system_header

#include "lumi/chord/render_spans.h"
#include "lumi/view.h"

namespace lumi::detail
{

// Opens a field for render_spans() with texels of this format. `out` stays as it was on failure.
inline ViewError open_for_spans(const uint8_t* bytes, size_t size, TexelFormat texels, Field& out)
{
    Field opened;
    if (const FieldError error = open_field(bytes, size, opened); error != FieldError::none) return view_error(error);
    if (opened.texel_format != texels) return ViewError::other_renderer;
    if (!fits_spans(opened)) {
        const bool is_aligned = reinterpret_cast<uintptr_t>(bytes) % 4 == 0;
        return is_aligned ? ViewError::other_renderer : ViewError::unaligned_field;
    }
    out = opened;
    return ViewError::none;
}

// Field and camera, which every renderer of chord fields takes.
template <class Texel>
struct ChordState {
    Field field{};
    Camera camera{};

    ViewError open(const uint8_t* bytes, size_t size)
    {
        Field opened;
        if (const FieldError error = open_field(bytes, size, opened); error != FieldError::none)
            return view_error(error);
        if (opened.texel_format != Texel::kFormat) return ViewError::other_renderer;
        field = opened;
        return ViewError::none;
    }

    ViewError look(const Pose& pose, const Image& image) { return view_error(make_camera(pose, image, camera)); }
};

// The spans that render_spans() tells apart.
constexpr bool is_span(int32_t px)
{
    return px == 2 || px == 4 || px == 8 || px == 16;
}

// Nothing of a frame is prepared that two cores could share.
struct NoHalves {
    void prepare(int32_t, uint32_t) {}
};

}  // namespace lumi::detail

namespace lumi
{

// By spans, render_spans(). The mode is how many pixels may lie between exact hits: 2, 4, 8 or 16; any other is
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
    class State
    {
    public:
        ViewError open(const uint8_t* bytes, size_t size)
        {
            return detail::open_for_spans(bytes, size, Texel::kFormat, state_.field);
        }

        template <class... Halves>
        ViewError look(const Pose& pose, const Image& image, Mode span_px, const Halves&...)
        {
            if (!detail::is_span(span_px)) return ViewError::wrong_span;
            const ViewError error = state_.look(pose, image);
            if (error == ViewError::none) span_px_ = span_px;
            return error;
        }

        PixelRect bounds() const { return detail::covered_rectangle(state_.camera); }

        template <class Background>
        ViewError draw(const Stripe& stripe, const detail::StripePart&, const Background& background, uint32_t*) const
        {
            const RenderError error = render_spans<Reconstruction, Texel, typename ScreenOf::Pixel>(
                state_.field, state_.camera, background, stripe, span_px_);
            return error == RenderError::none ? ViewError::none : ViewError::other_renderer;
        }

    private:
        detail::ChordState<Texel> state_{};
        Mode span_px_ = 0;
    };
};

// Every pixel by itself, render(): for fields that spans do not draw, at any address.
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
        ViewError open(const uint8_t* bytes, size_t size) { return state_.open(bytes, size); }
        template <class... Halves>
        ViewError look(const Pose& pose, const Image& image, Mode, const Halves&...)
        {
            return state_.look(pose, image);
        }

        PixelRect bounds() const { return detail::covered_rectangle(state_.camera); }

        template <class Background>
        ViewError draw(const Stripe& stripe, const detail::StripePart&, const Background& background, uint32_t*) const
        {
            const RenderError error = render<Reconstruction, Texel, typename ScreenOf::Pixel>(
                state_.field, state_.camera, background, stripe);
            return error == RenderError::none ? ViewError::none : ViewError::other_renderer;
        }

    private:
        detail::ChordState<Texel> state_{};
    };
};

}  // namespace lumi
