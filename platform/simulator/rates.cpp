// SPDX-License-Identifier: MIT
#include "rates.h"

#include <cstring>

namespace simulator
{
namespace
{

struct Rate {
    const char* chip;
    double frames_per_second;
};
#include "rates.inc"

}  // namespace

double rate_of(const char* chip)
{
    for (const Rate& rate : kRates)
        if (std::strcmp(rate.chip, chip) == 0) return rate.frames_per_second;
    return 0;
}

std::string chip_names()
{
    std::string names;
    for (const Rate& rate : kRates) names += (names.empty() ? "" : "|") + std::string(rate.chip);
    return names;
}

}  // namespace simulator
