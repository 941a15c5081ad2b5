// SPDX-License-Identifier: MIT
#include "lumi/tools/psnr.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace lumi::tools
{

double psnr_db(const Picture& a, const Picture& b)
{
    assert(same_size(a, b) && !a.rgb.empty());
    constexpr double kPeak = 255;
    uint64_t squares = 0;  // exact: 255² · 3 · 2^40 pixels fit
    for (size_t i = 0; i < a.rgb.size(); ++i) {
        const int difference = a.rgb[i] - b.rgb[i];
        squares += static_cast<uint64_t>(difference * difference);
    }
    if (squares == 0) return std::numeric_limits<double>::infinity();
    const double mean = static_cast<double>(squares) / static_cast<double>(a.rgb.size());
    return 10 * std::log10(kPeak * kPeak / mean);
}

}  // namespace lumi::tools
