// SPDX-License-Identifier: MIT
#include "view.h"

using namespace lumi;
using namespace lumi::detail;
using c::code;

#ifdef LUMI_C_DRAWS_SURFACES
lumi_error lumi_turn(lumi_view* view, uint32_t part, uint32_t turns32)
{
    return code(view == nullptr ? ViewError::no_field : view->turn(part, turns32));
}

lumi_error lumi_slide(lumi_view* view, uint32_t part, int32_t offset_q20)
{
    return code(view == nullptr ? ViewError::no_field : view->slide(part, offset_q20));
}

lumi_changes lumi_changed(const lumi_view* view, uint32_t align_x, uint32_t align_y)
{
    lumi_changes result = {};
    if (view == nullptr) return result;
    if (view->has_spans()) return {{{0, 0, view->screen().width_px, view->screen().height_px}}, 1};
    const ChangedRects changed = view->changed(align_x, align_y);
    for (; result.count < changed.count; ++result.count) {
        const PixelRect& r = changed.rect[result.count];
        result.rect[result.count] = {r.x_px, r.y_px, r.width_px, r.height_px};
    }
    return result;
}
#endif
