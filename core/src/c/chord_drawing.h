// SPDX-License-Identifier: MIT
// How lumi.h draws chord fields of one or several texel formats.
#pragma once

#include "lumi/chord/view.h"
#include "lumi/lumi.h"

namespace lumi::detail
{

template <class Pixel, class... Texels>
class ChordDrawingInC : public SpansState<Linear, Pixel, Texels...>
{
    using Spans = SpansState<Linear, Pixel, Texels...>;

public:
    using Field = lumi::Field;

    static ViewError open(const uint8_t* bytes, size_t size, const lumi_screen& screen, Field& out)
    {
        const ViewError error = open_chord<true, Texels...>(bytes, size, out);
        return error == ViewError::none && !is_span(screen.mode) ? ViewError::wrong_span : error;
    }

    // Whether modes are pixels between exact hits; else they are those of SurfaceMode.
    static constexpr bool has_spans() { return true; }
    // The bytes that a view needs behind itself.
    static size_t bytes_of(const Field&, const lumi_screen&) { return 0; }

    void begin(const Field& field, const lumi_screen&, void*) { this->field_ = field; }

    template <class Background>
    ViewError draw(const Stripe& stripe, const PixelSize& part, const Background& background, uint32_t* samples) const
    {
        if constexpr (kKeepsCoverage<Background>)
            return ViewError::other_renderer;
        else
            return Spans::draw(stripe, part, background, samples);
    }

    ViewError draw_coverage(const Stripe&, const PixelSize&, uint32_t*) const { return ViewError::other_renderer; }
};

}  // namespace lumi::detail
