// SPDX-License-Identifier: MIT
#include "view.h"

using namespace lumi;
using namespace lumi::detail;
using c::code;

namespace
{

// What lies in a lumi_quality.
struct Quality {
    QualityLadder ladder;
    bool has_spans;

    static void* operator new(size_t, void* memory) { return memory; }
};
static_assert(sizeof(Quality) <= sizeof(lumi_quality) && alignof(Quality) <= alignof(lumi_quality),
              "a lumi_quality holds it");

}  // namespace

lumi_error lumi_quality_start(lumi_quality* quality, const lumi_view* view, lumi_quality_limits limits)
{
    constexpr uint32_t kMostBudget = 1u << 29;
    if (view == nullptr) return code(ViewError::no_field);
    if (quality == nullptr || limits.budget >= kMostBudget) return code(ViewError::bad_argument);
    LadderLimits ladder{};
    if (const ViewError error = view->drawing.limit(limits, ladder); error != ViewError::none) return code(error);
    new (quality) Quality{QualityLadder(ladder), view->drawing.has_spans()};
    return code(ViewError::none);
}

lumi_frame_quality lumi_quality_next(lumi_quality* q, uint32_t last_frame, bool moving)
{
    Quality& quality = *reinterpret_cast<Quality*>(q);
    const bool draws = quality.ladder.next(last_frame, moving);
    const uint8_t step = quality.ladder.step();
#ifdef LUMI_C_TEXEL
    if (quality.has_spans) return {draws, static_cast<uint8_t>(span_px_of(static_cast<QualityStep>(step)))};
#endif
    return {draws, step};
}
