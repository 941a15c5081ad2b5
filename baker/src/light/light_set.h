// SPDX-License-Identifier: MIT
// All lights of a scene behind one sampling density; a light is chosen by its power.
#pragma once

#include "light/emitters.h"
#include "light/fixtures.h"
#include "light/sky.h"

namespace lumi::baker
{

class LightSet
{
public:
    // Borrows the first three; they must outlive the set.
    LightSet(const Mesh& mesh, const std::vector<Material>& materials, const std::vector<Texture>& textures,
             const Environment& environment, std::vector<Fixture> fixtures);

    bool empty() const { return choice_.empty(); }
    size_t count() const { return emitters_.count() + fixtures_.count(); }
    // Where fixtures stand that stand somewhere.
    std::vector<Vec3> positions() const { return fixtures_.positions(); }

    LightSample sample(const Vec3& from, float u_light, float u_select, const Vec2& u) const;
    // The same for the light from outside, without the emissive triangles of the objects themselves.
    bool none_outside() const { return outside_.empty(); }
    LightSample sample_outside(const Vec3& from, float u_light, float u_select, const Vec2& u) const;
    float outside_sky_pdf(const Vec3& direction) const;
    // All that decides their light, but for the emissive triangles, which are those of mesh, materials and textures.
    void add_to(Digest& digest) const;

    // Radiance of, and density of sample() for, a ray that leaves the scene, or that hits an emissive triangle.
    Rgb sky_radiance(const Vec3& direction) const { return sky_.radiance(direction); }
    float sky_pdf(const Vec3& direction) const;
    float emitter_pdf(uint32_t triangle, const Vec3& direction, float distance) const;
    // Calls seen(radiance, pdf) for each extra light that lies along the ray before its end.
    template <class Seen>
    void for_each_seen(const Ray& ray, const Seen& seen) const
    {
        fixtures_.for_each_seen(
            ray, [&](const Rgb& radiance, float pdf) { seen(radiance, pdf * choice_.probability(kFixtures)); });
    }

private:
    LightSample sample(const Distribution& choice, const Vec3& from, float u_light, float u_select,
                       const Vec2& u) const;
    float sky_pdf(const Distribution& choice, const Vec3& direction) const;

    enum Kind : size_t { kSky, kEmitters, kFixtures };

    Sky sky_;
    Emitters emitters_;
    Fixtures fixtures_;
    Distribution choice_, outside_;
};

}  // namespace lumi::baker
