// SPDX-License-Identifier: MIT
// How lumi.h draws chord fields of one or several texel formats: as ChordDrawing (chord/view.h) does.
#pragma once

#include "lumi/chord/quality.h"
#include "lumi/chord/view.h"
#include "lumi/lumi.h"

namespace lumi::detail
{

template <class Pixel, class... Texels>
class ChordDrawingInC
{
public:
    using Field = lumi::Field;

    static ViewError open(const uint8_t* bytes, size_t size, const lumi_screen& screen, Field& out)
    {
        ViewError error = ViewError::other_renderer;
        ((error = error == ViewError::other_renderer ? open_for_spans(bytes, size, Texels::kFormat, out) : error), ...);
        return error == ViewError::none && !is_span(screen.mode) ? ViewError::wrong_span : error;
    }

    static size_t bytes_of(const Field&, const lumi_screen&) { return 0; }

    void begin(const Field& field, const lumi_screen&, void*) { field_ = field; }

    static constexpr bool has_spans() { return true; }

    ViewError look(const Pose& pose, const Image& image, uint8_t span_px)
    {
        if (!is_span(span_px)) return ViewError::wrong_span;
        const ViewError error = view_error(make_camera(pose, image, camera_));
        if (error == ViewError::none) span_px_ = span_px;
        return error;
    }

    PixelRect bounds() const { return covered_rectangle(camera_); }

    template <class Background>
    ViewError draw(const Stripe& stripe, const StripePart&, const Background& background) const
    {
        if constexpr (kKeepsCoverage<Background>) {
            return ViewError::other_renderer;
        } else {
            const RenderError error = with_texel(
                field_.texel_format,
                [&](auto texel) {
                    return render_spans<Linear, decltype(texel), Pixel>(field_, camera_, background, stripe, span_px_);
                },
                TexelList<Texels...>());
            return error == RenderError::none ? ViewError::none : ViewError::other_renderer;
        }
    }

    ViewError draw_coverage(const Stripe&, const StripePart&) const { return ViewError::other_renderer; }

    ViewError limit(const lumi_quality_limits& limits, LadderLimits& out) const
    {
        QualityStep coarsest{}, moving{}, resting{};
        const bool are_modes = find_step(limits.coarsest, coarsest) && find_step(limits.finest_moving, moving) &&
                               find_step(limits.finest_resting, resting);
        if (!are_modes || coarsest > moving || moving > resting) return ViewError::bad_argument;
        out = ladder_limits(QualityLimits{limits.budget, coarsest, moving, resting});
        return ViewError::none;
    }

private:
    static bool find_step(uint8_t span_px, QualityStep& out)
    {
        constexpr QualityStep kSteps[] = {QualityStep::spans16, QualityStep::spans8, QualityStep::spans4,
                                          QualityStep::spans2};
        for (const QualityStep step : kSteps) {
            out = step;
            if (span_px_of(step) == span_px) return true;
        }
        return false;
    }

    Field field_;
    Camera camera_;
    uint8_t span_px_;
};

}  // namespace lumi::detail
