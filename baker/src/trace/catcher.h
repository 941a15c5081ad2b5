// SPDX-License-Identifier: MIT
// A shadow catcher: a level disc of which rays from outside the scene see nothing but the shadows on it.
//
// Such a ray that meets its upper side first is covered by black with a probability, as a surface of that opacity
// would do it; else it goes on behind as if the disc were not there. Nothing else sees the catcher: it sends no light
// back to the objects, shades nothing, and from below it is not there.
//
// The opacity is the share of light that does not arrive, 1 - E/E0: E is the irradiance (as luminance) that arrives
// at the point straight from the environment and the extra lights, E0 what would arrive without the objects. What the
// objects themselves emit or reflect counts in neither: it would not be there without them either, and a catcher can
// only darken (compare P. Debevec, "Rendering Synthetic Objects into Real Scenes", SIGGRAPH 1998, section 6).
#pragma once

#include <optional>

#include "geometry/accelerator.h"
#include "math/sampler.h"
#include "model/scene_parts.h"

namespace lumi::baker
{

// Where the ray meets the upper side of the catcher, if it does before its end. Up is +z, as in SceneData.
std::optional<float> distance_to_catcher(const Disc& catcher, const Ray& ray);

// An estimate of 1 - E/E0 with one shadow ray: of kCatcherCandidates samples of lights and sky one is drawn in
// proportion to what it adds to E0 (Talbot et al., "Importance Resampling for Global Illumination", EGSR 2005), and the
// estimate is the share of its light that is blocked: 0 or 1 but for half transparent surfaces. Always 0 where nothing
// is blocked, also without any light, and 1 where all is. The mean is that of a ratio of two sums over the candidates,
// which is biased by O(1/kCatcherCandidates) where their weights vary; tests/baker/trace/catcher_test.cpp measures it.
inline constexpr size_t kCatcherCandidates = 32;
float shadow_at(const SceneData& scene, const Vec3& position, Sampler& sampler);

// Bakes call this before they start. It throws BakeError if the scene has a catcher or a volume and the texels only
// know "covered" and "not covered": a soft shadow would become a black blot, smoke a solid body.
void require_partial_coverage(const SceneData& scene, bool texels_have_it);

}  // namespace lumi::baker
