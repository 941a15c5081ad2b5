// SPDX-License-Identifier: MIT
// The report page begins with this where parts are named: for each what to take, its front, and pictures of it; then a
// table of all rows.
#pragma once

#include <string>

#include "quality/page.h"
#include "trade/trade.h"

namespace lumi::trade
{

quality::PageLead lead_of(const Trade& trade, const quality::ReportData& report);

}  // namespace lumi::trade
