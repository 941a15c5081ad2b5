// SPDX-License-Identifier: MIT
// All lights of a scene: the sky, and its lamps, which are emissive triangles and extra lights. A lamp is chosen by its
// power.
//
// Sky and lamps are sampled apart. Each gets its share, by power, of the samples that a point may take, but at most
// one. So a point takes two where both matter, and mostly one where the power of one is small. Densities count all
// samples: over all directions they add up to the number of samples that a point takes on average (to fewer where the
// sky is an even picture, whose samples find nothing).
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/mesh.h"
#include "image/texture.h"
#include "light/fixtures.h"
#include "light/light.h"
#include "light/sky.h"
#include "material/material.h"
#include "math/distribution.h"

namespace lumi::baker
{

// All emissive triangles of a mesh as one area light; a triangle is chosen by its power. Both sides shine.

class Emitters : public Light
{
public:
    // Borrows all; they must outlive the light.
    Emitters(const Mesh& mesh, const std::vector<Material>& materials, const std::vector<Texture>& textures);

    size_t count() const { return triangles_.size(); }
    // Solid-angle density of reaching, from a point, the emissive triangle that lies at `distance` along `direction`.
    float pdf(uint32_t triangle, const Vec3& direction, float distance) const;

    float power() const override;
    LightSample sample(const Vec3& from, float u_select, const Vec2& u) const override;

private:
    float mean_brightness(uint32_t triangle) const;
    float brightness(uint32_t triangle) const;
    const Material& material(uint32_t triangle) const { return materials_[mesh_.materials[triangle]]; }

    const Mesh& mesh_;
    const std::vector<Material>& materials_;
    const std::vector<Texture>& textures_;
    std::vector<uint32_t> triangles_;  // ascending
    std::vector<float> brightness_;    // one a triangle
    Distribution choice_;              // by area × brightness
};

// Radiance that a triangle emits at a place on it.
Rgb emission_at(const Mesh& mesh, const Material& material, const std::vector<Texture>& textures, uint32_t triangle,
                const Vec2& barycentric);

// One point takes these random numbers.
struct LightNumbers {
    Vec2 choice, place;
};

class LightSet
{
public:
    // Borrows the first three; they must outlive the set. samples: that a point may take, 1 or 2.
    LightSet(const Mesh& mesh, const std::vector<Material>& materials, const std::vector<Texture>& textures,
             const Environment& environment, std::vector<Fixture> fixtures, float samples);

    bool empty() const { return !(sky_samples_ + lamp_samples_ > 0); }
    size_t count() const { return emitters_.count() + fixtures_.count(); }
    // Where fixtures stand that stand somewhere.
    std::vector<Vec3> positions() const { return fixtures_.positions(); }

    bool takes_two() const { return takes_two_; }
    // Calls take(sample, u) for each sample that a point takes. u is uniform in [0, 1] again, for the caller's use.
    template <class Take>
    void sample(const Vec3& from, const LightNumbers& numbers, const Take& take) const
    {
        const float u = numbers.choice.x;
        if (u < sky_samples_)
            take(counted(sky_.sample(from, numbers.choice.y, numbers.place), sky_samples_), u / sky_samples_);
        if (u >= 1 - lamp_samples_)
            take(counted(lamp(from, numbers.choice.y, numbers.place), lamp_samples_), (1 - u) / lamp_samples_);
    }
    // All that decides their light, but for the emissive triangles, which are those of mesh, materials and textures.
    void add_to(Digest& digest) const;

    // Radiance of, and density of sample() for, a ray that leaves the scene, or that hits an emissive triangle.
    SkyLight sky(const Vec3& direction) const;
    float emitter_pdf(uint32_t triangle, const Vec3& direction, float distance) const;
    // Calls seen(radiance, pdf) for each extra light that lies along the ray before its end.
    template <class Seen>
    void for_each_seen(const Ray& ray, const Seen& seen) const
    {
        fixtures_.for_each_seen(
            ray, [&](const Rgb& radiance, float pdf) { seen(radiance, pdf * fixture_samples_); });
    }

private:
    static LightSample counted(LightSample sample, float samples)
    {
        sample.pdf *= samples;
        return sample;
    }
    LightSample lamp(const Vec3& from, float u_select, const Vec2& u) const;

    enum LampKind : size_t { kEmitters, kFixtures };

    Sky sky_;
    Emitters emitters_;
    Fixtures fixtures_;
    Distribution lamps_;
    bool takes_two_ = false;
    // Samples that a point takes of each kind, in the mean.
    float sky_samples_ = 0, lamp_samples_ = 0, emitter_samples_ = 0, fixture_samples_ = 0;
};

}  // namespace lumi::baker
