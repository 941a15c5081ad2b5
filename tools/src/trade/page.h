// SPDX-License-Identifier: MIT
// The report page begins with this where parts are named: for each what to take, its front, and pictures of it; then a
// table of all rows.
#pragma once

#include <string>

#include "quality/page.h"
#include "trade/trade.h"

namespace lumi::trade
{

// The picture of a trade: frames a second across, accuracy up, flash as the area of a mark.

// An <svg> of one part: rows of its front are numbered from 1 in the front's order, all others grey. Colours are those
// of page_style.h.
std::string chart_of(const Trade& trade, size_t part);

quality::PageLead lead_of(const Trade& trade, const quality::ReportData& report);

}  // namespace lumi::trade
