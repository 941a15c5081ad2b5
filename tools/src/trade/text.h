// SPDX-License-Identifier: MIT
// Tells a trade in words, for people and for machines.
#pragma once

#include "trade/trade.h"

namespace lumi::trade
{

// "10.4", "0.28": rates of exact pixels are far below one.
std::string rate_text(double frames_per_second);

// Returns "product-250kB.lumi, antialiased".
std::string name_of(const Row& row);
// "30.8 dB at 11.2 frames a second (dearest pose 7.1), 235 kB of flash, 63.0 kB of RAM".
std::string figures_text(const Row& row, size_t part);
// "RP2040 at 10 frames a second".
std::string pace_text(const planner::Pace& pace);

// Says what is recommended for each part.
std::string text_of(const Trade& trade);

// Returns `report`, the JSON of the report, with "trade": parts and rows.
std::string with_trade(const std::string& report, const Trade& trade);

}  // namespace lumi::trade
