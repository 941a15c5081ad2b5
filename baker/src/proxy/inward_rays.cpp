// SPDX-License-Identifier: MIT
#include "proxy/inward_rays.h"

#include "lumi/guided/guided_chart.h"

namespace lumi::baker
{
namespace
{

Vec3 from_q14(const int16_t (&v)[3])
{
    constexpr float kUnit = 1.0f / 16384;
    return {v[0] * kUnit, v[1] * kUnit, v[2] * kUnit};
}

Vec3 from_q30(const Vec3q30& p)
{
    constexpr double kUnit = 1.0 / kOneQ30;
    return normalized(
        {static_cast<float>(p.x * kUnit), static_cast<float>(p.y * kUnit), static_cast<float>(p.z * kUnit)});
}

}  // namespace

InwardRays::InwardRays(const Lattice& origins, uint32_t origin) : origin_(from_q30(point(origins, origin)))
{
    const ChartFrame frame = chart_frame(point(origins, origin));
    tangent_ = from_q14(frame.tangent_q14);
    bitangent_ = from_q14(frame.bitangent_q14);
}

Ray InwardRays::ray(const Vec2& place) const
{
    const float inwards = std::sqrt(std::max(0.0f, 1 - place.x * place.x - place.y * place.y));
    return {origin_, normalized(tangent_ * place.x + bitangent_ * place.y - origin_ * inwards)};
}

}  // namespace lumi::baker
