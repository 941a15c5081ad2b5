// SPDX-License-Identifier: MIT
#include "scene/smoothing.h"

#include <map>

namespace lumi::baker
{
namespace
{

using Key = std::pair<uint32_t, int32_t>;  // group, vertex

// Newell's sum: the area vector of a polygon, bent or not.
Vec3 area_vector(const ObjContent& content, const ObjFace& face)
{
    Vec3 sum;
    const Vec3 base = content.positions[static_cast<size_t>(content.corners[face.first].position)];
    for (uint32_t k = 1; k + 1 < face.count; ++k) {
        const Vec3 a = content.positions[static_cast<size_t>(content.corners[face.first + k].position)] - base;
        const Vec3 b = content.positions[static_cast<size_t>(content.corners[face.first + k + 1].position)] - base;
        sum = sum + cross(a, b);
    }
    return sum;
}

}  // namespace

void smooth_normals(ObjContent& content)
{
    std::map<Key, Vec3> sums;
    for (const ObjFace& face : content.faces) {
        if (face.smoothing != 0) {
            const Vec3 area = area_vector(content, face);
            for (uint32_t k = 0; k < face.count; ++k) {
                Vec3& sum = sums[{face.smoothing, content.corners[face.first + k].position}];
                sum = sum + area;
            }
        }
    }
    std::map<Key, int32_t> places;
    for (const auto& [key, sum] : sums) {
        places[key] = static_cast<int32_t>(content.normals.size());
        content.normals.push_back(sum);
    }
    for (const ObjFace& face : content.faces) {
        for (uint32_t k = 0; k < face.count && face.smoothing != 0; ++k) {
            ObjCorner& corner = content.corners[face.first + k];
            corner.normal = corner.normal == kNoIndex ? places[{face.smoothing, corner.position}] : corner.normal;
        }
    }
}

}  // namespace lumi::baker
