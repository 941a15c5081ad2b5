// SPDX-License-Identifier: MIT
#include "mesh/mesh_warnings.h"

#include <cmath>

namespace lumi::baker
{
namespace
{

constexpr double kMaxMissed = 0.01;
constexpr double kFarShort = 0.6;  // of the triangles asked for

std::string percent(double share)
{
    const long tenths = std::lround(share * 1000);
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " %";
}

}  // namespace

std::vector<std::string> mesh_warnings(const MeshLoss& loss, size_t asked, size_t got, bool of_volume)
{
    std::vector<std::string> warnings;
    if (loss.missed > kMaxMissed) {
        warnings.push_back("the mesh misses " + percent(loss.missed) + " of what can be seen: " +
                           (of_volume ? "what is soft or half transparent; a chord field shows that, but blurs the rest"
                                      : "ask for more triangles, or thicken parts thinner than a pixel"));
    }
    if (loss.rough) {
        warnings.push_back(
            "the scene could only be simplified roughly, since its surfaces are torn or run through each other: weld "
            "its vertices, give neighbouring faces one winding, or ask for more triangles");
    }
    if (static_cast<double>(got) < kFarShort * static_cast<double>(asked)) {
        warnings.push_back("the mesh has " + std::to_string(got) + " triangles where " + std::to_string(asked) +
                           " were asked for: the shape cannot be simplified to that number; ask for more");
    }
    if (loss.holes > 0) {
        warnings.push_back("the mesh has " + std::to_string(loss.holes) + " holes, the largest of " +
                           std::to_string(loss.largest_hole) + " pixels at 240 x 240: ask for more triangles");
    }
    return warnings;
}

}  // namespace lumi::baker
