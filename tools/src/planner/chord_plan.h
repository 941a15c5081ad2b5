// SPDX-License-Identifier: MIT
// From a size in bytes to a chord field: as many directions as origins, a byte a texel, which shows most; how many, the
// bytes tell. Nothing is traced.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "lumi/baker/chord.h"

namespace lumi::planner
{

// No plan fits; what() says what would.
struct NoPlan : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ChordTask {
    uint64_t budget_bytes = 0;
    baker::BakeSettings settings;  // some are set by hand, and a plan leaves others alone
    bool origins_by_hand = false, directions_by_hand = false;
    std::function<uint32_t(uint32_t origins)> cap;  // how many of so many origins are kept; empty: all
};

// The largest that fits. Throws NoPlan where nothing does, BakeError for what cannot be baked in any size.
baker::BakeSettings plan_chord(const ChordTask& task);

// Returns "700 origins (uppermost 630), 700 directions, palette8, 441 kB".
std::string text_of(const baker::BakeSettings& plan);

// The options of `lumi bake` that set the same by hand.
std::string options_of(const baker::BakeSettings& plan);

}  // namespace lumi::planner
