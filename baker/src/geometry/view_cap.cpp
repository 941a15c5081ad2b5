// SPDX-License-Identifier: MIT
#include "geometry/view_cap.h"

#include <algorithm>
#include <cmath>

namespace lumi::baker
{

// Seen from the centre, the part of the line before the sphere is an arc of a great circle, from where it enters the
// sphere to where it comes from.
bool ViewCap::sees(const Ray& line) const
{
    if (is_whole()) return true;
    const Vec3 foot = line.origin - line.direction * dot(line.origin, line.direction);
    const float r2 = std::min(1.0f, dot(foot, foot)), half_chord = std::sqrt(1 - r2);
    const float far = -line.direction.z, front = foot.z - half_chord * line.direction.z;
    float highest = std::max(far, front);
    if (foot.z > 0 && far * r2 >= foot.z * half_chord)  // the arc goes over its circle's highest point
        highest = std::sqrt(foot.z * foot.z / r2 + far * far);
    return highest >= lowest_;
}

}  // namespace lumi::baker
