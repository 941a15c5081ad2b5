// SPDX-License-Identifier: MIT
#include "metrics/metrics.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace lumi::tools
{

namespace
{

double db_of(uint64_t squares, uint64_t values)
{
    constexpr double kPeak = 255;
    if (squares == 0) return std::numeric_limits<double>::infinity();
    return 10 * std::log10(kPeak * kPeak * static_cast<double>(values) / static_cast<double>(squares));
}

// Exact: 255² · 3 · 2^40 pixels fit.
uint64_t squared_difference(const uint8_t* a, const uint8_t* b, size_t count)
{
    uint64_t squares = 0;
    for (size_t i = 0; i < count; ++i) squares += static_cast<uint64_t>((a[i] - b[i]) * (a[i] - b[i]));
    return squares;
}

}  // namespace

double psnr_db(const Picture& a, const Picture& b)
{
    check_precondition(same_size(a, b) && !a.rgb.empty(), "pictures of two sizes cannot be compared");
    return db_of(squared_difference(a.rgb.data(), b.rgb.data(), a.rgb.size()), a.rgb.size());
}

double psnr_db(const Picture& a, const Picture& b, const Mask& mask)
{
    check_precondition(same_size(a, b) && 3 * mask.values.size() == a.rgb.size(),
                       "pictures of two sizes cannot be compared");
    uint64_t squares = 0, values = 0;
    for (size_t i = 0; i < mask.values.size(); ++i) {
        if (mask.values[i] == 0) continue;
        squares += squared_difference(&a.rgb[3 * i], &b.rgb[3 * i], 3);
        values += 3;
    }
    check_precondition(values != 0, "the mask is empty");
    return db_of(squares, values);
}

Picture error_picture(const Picture& a, const Picture& b)
{
    check_precondition(same_size(a, b), "pictures of two sizes cannot be compared");
    Picture errors = a;
    for (size_t i = 0; i < errors.rgb.size(); ++i)
        errors.rgb[i] = static_cast<uint8_t>(std::min(255, kErrorGain * std::abs(a.rgb[i] - b.rgb[i])));
    return errors;
}

}  // namespace lumi::tools
