// SPDX-License-Identifier: MIT
// A point that a ray meets: position, normals and material, looked at from the ray's side.
#pragma once

#include <optional>

#include "material/texture_slot.h"
#include "math/sampler.h"
#include "math/vec3.h"
#include "scene/scene_data.h"

namespace lumi::baker
{

struct HitPoint {
    Hit hit;
    Vec3 position;
    Vec3 geometric_normal;  // on the viewer's side
    Frame frame;            // around the shading normal, on the viewer's side
    const Material* material;
    PointValues values;  // the material's values at this point
    Rgb emission;
    bool folds = false;  // light that the shading normal would send below the surface is mirrored up

    // `direction` mirrored in the surface.
    Vec3 mirrored_up(const Vec3& direction) const
    {
        return direction - geometric_normal * (2 * dot(direction, geometric_normal));
    }
    // Makes a ray from just above (or, for directions through the surface, below) this point.
    Ray ray_towards(const Vec3& direction) const;
    Ray ray_to_light(const Vec3& direction, float distance) const;
};

// The surface at a hit.
HitPoint hit_point_at(const SceneData& scene, const Ray& ray, const Hit& hit);

// The nearest hit that does not let the ray pass: each surface on the way is opaque with the probability of its
// opacity.
std::optional<Hit> closest_opaque(const SceneData& scene, const Ray& ray, Sampler& sampler);
// Does the same, and `through` gets the colour of what the ray passes, on average over chance.
std::optional<Hit> closest_opaque(const SceneData& scene, const Ray& ray, Sampler& sampler, Rgb& through);
// Does the same as the first, and `passed` gets the surfaces that it passes, with distances along the ray.
std::optional<Hit> closest_opaque(const SceneData& scene, const Ray& ray, Sampler& sampler, std::vector<Hit>& passed);

// The opacity of the surface at a hit: the probability that it stops a ray. A pane has that of rays from straight
// above.
float opacity_of(const SceneData& scene, const Hit& hit);
// The share of the light of this direction that passes straight on; on average its colours pass as rays do.
Rgb passing_light(const SceneData& scene, const Hit& hit, const Vec3& direction);
// How much of the light that stops there is scattered: 1 but for panes, which let more or less light through than they
// let rays pass.
float weight_of_stop(const SceneData& scene, const Hit& hit);

// How far the ray gets: to the nearest hit that does not let it pass, or to where the volume scatters or absorbs it.
// Draws what a path draws there. Infinite if nothing stops it.
float first_meeting(const SceneData& scene, const Ray& ray, Sampler& sampler);

// The share of light that surfaces let through, between 0 and 1 in each colour.
Rgb transmittance(const SceneData& scene, const Ray& ray);
// An estimate of what surfaces and the volume together let through.
Rgb transmittance(const SceneData& scene, const Ray& ray, Sampler& sampler);

// From a point that lies on no surface to just before a light.
Ray ray_to_light(const Vec3& position, const Vec3& direction, float distance);

}  // namespace lumi::baker
