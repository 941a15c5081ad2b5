// SPDX-License-Identifier: MIT
#include "planner/plan.h"

#include "lumi/texel.h"

namespace lumi::planner
{

namespace
{

bool has_cap(const baker::BakeSettings& s)
{
    return s.used_origins != 0 && s.used_origins != s.origins;
}

}  // namespace

std::string text_of(const Plan& plan)
{
    const baker::BakeSettings& s = plan.chord;
    const std::string cap = has_cap(s) ? " (uppermost " + std::to_string(s.used_origins) + ")" : "";
    return "chord, " + std::to_string(s.origins) + " origins" + cap + ", " + std::to_string(s.directions) +
           " directions, " + texel_name(s.texel);
}

std::string options_of(const Plan& plan)
{
    const baker::BakeSettings& s = plan.chord;
    const std::string cap = has_cap(s) ? " --cap " + std::to_string(s.used_origins) : "";
    return "--layout chord --origins " + std::to_string(s.origins) + cap + " --directions " +
           std::to_string(s.directions) + " --texel " + texel_name(s.texel);
}

}  // namespace lumi::planner
