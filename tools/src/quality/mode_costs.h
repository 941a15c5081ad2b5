// SPDX-License-Identifier: MIT
// What modes cost, as `lumi bench --json` wrote it.
#pragma once

#include <string>
#include <vector>

namespace lumi::quality
{

struct ModeCost {
    std::string layout, core, mode;
    std::string texel;  // chord alone
    int span = 0;       // likewise; 0: every pixel exact
    double instructions_per_pixel = 0;
};

// The rows of the generic view. Throws Failure for a file that is something else.
std::vector<ModeCost> read_mode_costs(const std::string& path);

}  // namespace lumi::quality
