// SPDX-License-Identifier: MIT
// All lights of a scene behind one sampling density; a light is chosen by its power.
#pragma once

#include "emitters.h"
#include "sky.h"

namespace lumi::baker
{

class LightSet
{
public:
    LightSet(const Mesh& mesh, const std::vector<Material>& materials, const Environment& environment);

    bool empty() const { return sky_share_ <= 0 && emitter_share_ <= 0; }
    size_t emitter_count() const { return emitters_.count(); }

    LightSample sample(const Vec3& from, float u_light, float u_select, const Vec2& u) const;

    // Radiance of, and density of sample() for, a ray that leaves the scene, or that hits an emissive triangle.
    Rgb sky_radiance(const Vec3& direction) const { return sky_.radiance(direction); }
    float sky_pdf(const Vec3& direction) const;
    float emitter_pdf(uint32_t triangle, const Vec3& direction, float distance) const;

private:
    Sky sky_;
    Emitters emitters_;
    float sky_share_ = 0, emitter_share_ = 0;  // probabilities of choosing each
};

}  // namespace lumi::baker
