// SPDX-License-Identifier: MIT
#include "view.h"

lumi_error lumi_draw_over_colour(lumi_view* view, lumi_stripe stripe, lumi_colour c)
{
    return lumi::detail::c::drawn_over(lumi::OverColour{{c.r, c.g, c.b}}, view, stripe);
}
