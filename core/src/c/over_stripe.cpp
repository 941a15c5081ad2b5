// SPDX-License-Identifier: MIT
#include "view.h"

lumi_error lumi_draw_over_stripe(lumi_view* view, lumi_stripe stripe)
{
    return lumi::detail::c::drawn_over(lumi::OverStripe{}, view, stripe);
}
