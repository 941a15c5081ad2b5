// SPDX-License-Identifier: MIT
#include "lumi/quality.h"

#include "view.h"

using namespace lumi;
using namespace lumi::detail;
using c::code;

namespace
{

// A lumi_quality holds this.
struct Quality {
    QualityLadder ladder;
    bool has_spans;

    static void* operator new(size_t, void* memory) { return memory; }
};
static_assert(sizeof(Quality) <= sizeof(lumi_quality) && alignof(Quality) <= alignof(lumi_quality),
              "a lumi_quality holds it");

#ifdef LUMI_C_DRAWS_SURFACES
bool find_mode(uint8_t number, SurfaceMode& out)
{
    out = static_cast<SurfaceMode>(number);
    return number <= LUMI_TWO_BY_TWO;
}
#endif

#ifdef LUMI_C_TEXEL
bool find_mode(uint8_t span_px, QualityStep& out)
{
    constexpr QualityStep kSteps[] = {QualityStep::spans16, QualityStep::spans8, QualityStep::spans4,
                                      QualityStep::spans2};
    for (const QualityStep step : kSteps) {
        out = step;
        if (span_px_of(step) == span_px) return true;
    }
    return false;
}
#endif

// Nothing of `out` is set where limits are no modes, or in the wrong order.
template <class Mode>
bool find_limits(const lumi_quality_limits& limits, QualityLimits<Mode>& out)
{
    out.budget = limits.budget;
    return find_mode(limits.coarsest, out.coarsest) && find_mode(limits.finest_moving, out.finest_moving) &&
           find_mode(limits.finest_resting, out.finest_resting) && out.coarsest <= out.finest_moving &&
           out.coarsest <= out.finest_resting;
}

ViewError find_ladder(const lumi_view& view, const lumi_quality_limits& limits, LadderLimits& out)
{
#ifdef LUMI_C_TEXEL
    if (view.has_spans()) {
        QualityLimits<QualityStep> spans = {};
        if (!find_limits(limits, spans) || spans.finest_moving > spans.finest_resting) return ViewError::bad_argument;
        out = ladder_limits(spans);
        return ViewError::none;
    }
#endif
#ifdef LUMI_C_DRAWS_SURFACES
    QualityLimits<SurfaceMode> modes = {};
    if (!find_limits(limits, modes)) return ViewError::bad_argument;
    const SurfaceMode finest = static_cast<SurfaceMode>(view.screen().mode);
    if (modes.finest_moving > finest || modes.finest_resting > finest) return ViewError::mode_too_fine;
    out = ladder_limits(modes);
#endif
    return ViewError::none;
}

}  // namespace

lumi_error lumi_quality_start(lumi_quality* quality, const lumi_view* view, lumi_quality_limits limits)
{
    constexpr uint32_t kMostBudget = 1u << 29;
    if (view == nullptr) return code(ViewError::no_field);
    if (quality == nullptr || limits.budget >= kMostBudget) return code(ViewError::bad_argument);
    LadderLimits ladder{};
    if (const ViewError error = find_ladder(*view, limits, ladder); error != ViewError::none) return code(error);
    new (quality) Quality{QualityLadder(ladder), view->has_spans()};
    return code(ViewError::none);
}

lumi_frame_quality lumi_quality_next(lumi_quality* q, uint32_t last_frame, bool moving)
{
    Quality& quality = *reinterpret_cast<Quality*>(q);
    const bool draws = quality.ladder.next(last_frame, moving);
    const uint8_t step = quality.ladder.step();
    if (quality.has_spans) return {draws, static_cast<uint8_t>(span_px_of(static_cast<QualityStep>(step)))};
    return {draws, step};
}
