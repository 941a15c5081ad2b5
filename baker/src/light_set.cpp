// SPDX-License-Identifier: MIT
#include "light_set.h"

namespace lumi::baker
{

LightSet::LightSet(const Mesh& mesh, const std::vector<Material>& materials, const Environment& environment)
    : sky_(environment), emitters_(mesh, materials)
{
    const float total = sky_.power() + emitters_.power();
    if (total > 0) {
        sky_share_ = sky_.power() / total;
        emitter_share_ = 1 - sky_share_;
    }
}

LightSample LightSet::sample(const Vec3& from, float u_light, float u_select, const Vec2& u) const
{
    const bool sky = u_light < sky_share_;
    LightSample s = sky ? sky_.sample(from, u_select, u) : emitters_.sample(from, u_select, u);
    s.pdf *= sky ? sky_share_ : emitter_share_;
    return s;
}

float LightSet::sky_pdf(const Vec3& direction) const
{
    return sky_share_ > 0 ? sky_share_ * sky_.pdf(direction) : 0.0f;
}

float LightSet::emitter_pdf(uint32_t triangle, const Vec3& direction, float distance) const
{
    return emitter_share_ > 0 ? emitter_share_ * emitters_.pdf(triangle, direction, distance) : 0.0f;
}

}  // namespace lumi::baker
