// SPDX-License-Identifier: MIT
#include "scene/placement_fields.h"

#include <algorithm>

#include "scene/number_ranges.h"

namespace lumi::baker
{
namespace
{

constexpr NumberRange kScale = {-1e9, 1e9};

// One number for all axes, or three.
void read_scale(JsonFields& fields, Vec3& scale)
{
    const JsonValue* value = fields.find("scale");
    if (!value) return;
    if (value->kind == JsonValue::Kind::number) {
        const float all = static_cast<float>(fields.number_of(*value, "scale", kScale));
        scale = {all, all, all};
    } else {
        scale = fields.vector_of(*value, "scale", kScale);
    }
    constexpr float kLeast = 1e-9f;
    if (std::min({std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)}) < kLeast)
        fields.fail(*value, "'scale' flattens the object; choose numbers other than 0");
}

}  // namespace

Placement read_placement(JsonFields& fields)
{
    Placement placement;
    fields.vector("translate", kPlace, placement.translation);
    fields.vector("rotate", kAngle, placement.rotation_degrees);
    read_scale(fields, placement.scale);
    return placement;
}

}  // namespace lumi::baker
