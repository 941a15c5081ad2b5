// SPDX-License-Identifier: MIT
#include "scene/placement_members.h"

#include <algorithm>

#include "scene/number_ranges.h"

namespace lumi::baker
{
namespace
{

constexpr NumberRange kScale = {-1e9, 1e9};

// One number for all axes, or three.
void read_scale(JsonMembers& members, Vec3& scale)
{
    const JsonValue* value = members.find("scale");
    if (!value) return;
    if (value->kind == JsonValue::Kind::number) {
        const float all = static_cast<float>(members.number_of(*value, "scale", kScale));
        scale = {all, all, all};
    } else {
        scale = members.vector_of(*value, "scale", kScale);
    }
    constexpr float kLeast = 1e-9f;
    if (std::min({std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)}) < kLeast)
        members.fail(*value, "'scale' flattens the object; choose numbers other than 0");
}

}  // namespace

Placement read_placement(JsonMembers& members)
{
    Placement placement;
    members.vector("translate", kPlace, placement.translation);
    members.vector("rotate", kAngle, placement.rotation_degrees);
    read_scale(members, placement.scale);
    return placement;
}

}  // namespace lumi::baker
