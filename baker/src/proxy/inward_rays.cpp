// SPDX-License-Identifier: MIT
#include "proxy/inward_rays.h"

#include "math/frame.h"

namespace lumi::baker
{
namespace
{

Vec3 from_q30(const Vec3q30& p)
{
    constexpr double kUnit = 1.0 / kOneQ30;
    return normalized(
        {static_cast<float>(p.x * kUnit), static_cast<float>(p.y * kUnit), static_cast<float>(p.z * kUnit)});
}

}  // namespace

InwardRays::InwardRays(const Lattice& origins, uint32_t origin) : origin_(from_q30(point(origins, origin)))
{
    const Frame frame(origin_);
    tangent_ = frame.tangent;
    bitangent_ = frame.bitangent;
}

Ray InwardRays::ray(const Vec2& place) const
{
    const float inwards = std::sqrt(std::max(0.0f, 1 - place.x * place.x - place.y * place.y));
    return {origin_, normalized(tangent_ * place.x + bitangent_ * place.y - origin_ * inwards)};
}

}  // namespace lumi::baker
