// SPDX-License-Identifier: MIT
#include "planner/chord_plan.h"

#include "lumi/chord/texel.h"
#include "lumi/detail/lattice.h"
#include "terminal/text.h"

namespace lumi::planner
{

namespace
{

// A lattice that is not set by hand has this many points.
baker::BakeSettings sized(const ChordTask& task, uint32_t points)
{
    baker::BakeSettings s = task.settings;
    if (!task.origins_by_hand) s.origins = points;
    if (!task.directions_by_hand) s.directions = points;
    s.used_origins = task.cap ? task.cap(s.origins) : 0;
    return s;
}

bool fits(const ChordTask& task, uint32_t points)
{
    try {
        return baker::field_file_bytes(sized(task, points)) <= task.budget_bytes;
    } catch (const baker::BakeError&) {
        return false;  // more than the format holds
    }
}

bool has_cap(const baker::BakeSettings& s)
{
    return s.used_origins != 0 && s.used_origins != s.origins;
}

}  // namespace

baker::BakeSettings plan_chord(const ChordTask& task)
{
    const uint64_t least = baker::field_file_bytes(sized(task, 1));
    if (least > task.budget_bytes)
        throw NoPlan("nothing fits into " + tools::byte_text(task.budget_bytes) + "; the smallest that works takes " +
                     std::to_string(least) + " bytes");
    uint32_t low = 1, high = detail::kMaxLatticeSize + 1;
    while (high - low > 1) {
        const uint32_t middle = (low + high) / 2;
        (fits(task, middle) ? low : high) = middle;
    }
    return sized(task, low);
}

std::string text_of(const baker::BakeSettings& s)
{
    const std::string cap = has_cap(s) ? " (uppermost " + std::to_string(s.used_origins) + ")" : "";
    return std::to_string(s.origins) + " origins" + cap + ", " + std::to_string(s.directions) + " directions, " +
           detail::texel_name(s.texel) + ", " + tools::byte_text(baker::field_file_bytes(s));
}

std::string options_of(const baker::BakeSettings& s)
{
    const std::string cap = has_cap(s) ? " --cap " + std::to_string(s.used_origins) : "";
    return "--layout chord --origins " + std::to_string(s.origins) + cap + " --directions " +
           std::to_string(s.directions) + " --texel " + detail::texel_name(s.texel);
}

}  // namespace lumi::planner
