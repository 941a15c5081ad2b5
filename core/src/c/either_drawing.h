// SPDX-License-Identifier: MIT
// How lumi.h draws fields of both layouts: a view takes that of its field.
#pragma once

#include "lumi/lumi.h"
#include "lumi/view.h"

namespace lumi::detail
{

template <class Surface, class Chord>
class EitherDrawingInC
{
public:
    struct Field {
        bool is_chord;
        typename Surface::Field surface;
        typename Chord::Field chord;
    };

    static ViewError open(const uint8_t* bytes, size_t size, const lumi_screen& screen, Field& out)
    {
        const ViewError error = Surface::open(bytes, size, screen, out.surface);
        out.is_chord = error == ViewError::other_renderer;
        return out.is_chord ? Chord::open(bytes, size, screen, out.chord) : error;
    }

    static size_t bytes_of(const Field& field, const lumi_screen& screen)
    {
        return field.is_chord ? Chord::bytes_of(field.chord, screen) : Surface::bytes_of(field.surface, screen);
    }

    void begin(const Field& field, const lumi_screen& screen, void* memory)
    {
        is_chord_ = field.is_chord;
        if (is_chord_)
            chord_.begin(field.chord, screen, memory);
        else
            surface_.begin(field.surface, screen, memory);
    }

    bool has_spans() const { return is_chord_; }

    ViewError look(const Pose& pose, const Image& image, uint8_t mode)
    {
        return is_chord_ ? chord_.look(pose, image, mode) : surface_.look(pose, image, mode);
    }

    PixelRect bounds() const { return is_chord_ ? chord_.bounds() : surface_.bounds(); }

    template <class Background>
    ViewError draw(const Stripe& stripe, const StripePart& part, const Background& background) const
    {
        return is_chord_ ? chord_.draw(stripe, part, background) : surface_.draw(stripe, part, background);
    }

    ViewError draw_coverage(const Stripe& coverage, const StripePart& part) const
    {
        return is_chord_ ? chord_.draw_coverage(coverage, part) : surface_.draw_coverage(coverage, part);
    }

    ViewError limit(const lumi_quality_limits& limits, LadderLimits& out) const
    {
        return is_chord_ ? chord_.limit(limits, out) : surface_.limit(limits, out);
    }

private:
    Surface surface_;
    Chord chord_;
    bool is_chord_;
};

}  // namespace lumi::detail
