// SPDX-License-Identifier: MIT
// What one would do without this library, in the same harness.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bench/measure.h"

namespace lumi::bench
{

// What drawing the generic view costs.
struct BaselineCost {
    std::string title, core;
    Count count;
    uint32_t code_bytes;
};

// How much a method's pictures look like the path-traced reference, per view of kViewNames.
struct Likeness {
    std::string title;
    uint64_t flash_bytes;
    std::array<double, 3> psnr_db, ssim;
};

struct Baselines {
    std::vector<BaselineCost> costs;
    std::vector<Likeness> pictures;
};

Baselines measure_baselines(const Settings& settings, const Announce& announce);

}  // namespace lumi::bench
