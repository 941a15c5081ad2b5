// SPDX-License-Identifier: MIT
#include "chord/field_rays.h"

#include "math/unit_vector.h"
#include "math/warp.h"

namespace lumi::baker
{

Vec3 OriginDisc::at(const Vec2& u) const
{
    const Vec2 d = square_to_disc(u);
    return frame.normal + frame.tangent * (radius * d.x) + frame.bitangent * (radius * d.y);
}

OriginDisc FieldRays::disc(uint32_t i) const
{
    // π·radius² = 4π/M
    return {Frame(unit_vector(detail::point(origins_, i))), 2 / std::sqrt(static_cast<float>(origins_.size()))};
}

OriginDisc FieldRays::direction_disc(uint32_t j) const
{
    return {Frame(direction_point(j)), 2 / std::sqrt(static_cast<float>(directions_.size()))};
}

Vec3 FieldRays::direction_point(uint32_t j) const
{
    return unit_vector(detail::point(directions_, j));
}

std::optional<Ray> FieldRays::ray(const Vec3& start, const Vec3& target)
{
    const Vec3 towards = target - start;
    const float distance = length(towards);
    if (!(distance > 0)) return std::nullopt;
    return Ray{start, towards / distance, distance};
}

std::optional<Ray> FieldRays::parallel_ray(const Vec3& start, const Vec3& from, const Vec3& to)
{
    const std::optional<Ray> axis = ray(from, to);
    if (!axis) return std::nullopt;
    return Ray{start, axis->direction};
}

}  // namespace lumi::baker
