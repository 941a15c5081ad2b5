// SPDX-License-Identifier: MIT
// The picture of a trade: frames a second across, accuracy up, flash as the area of a mark.
#pragma once

#include <string>

#include "trade/trade.h"

namespace lumi::trade
{

// An <svg> of one part: rows of its front are numbered from 1 in the front's order, all others grey. Colours are those
// of page_style.h.
std::string chart_of(const Trade& trade, size_t part);

}  // namespace lumi::trade
