// SPDX-License-Identifier: MIT
// Unbiased estimates of the light along a ray: a path tracer that aims at lights at every bounce and weighs both ways
// of finding them by the power heuristic (Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997, ch.
// 9).
//
// A volume scatters by its medium's flights, and aims at lights in the same way.
//
// Deliberate limits: paths end after kMaxBounces (with Russian roulette their share is below 1e-6 of the light in
// any scene whose albedo is below 0.8), or after kMaxScatterings in a volume; light that would leave on the far side of
// a smooth-shaded face is lost; lights without a size send none through glass, whose shadow for them is black.
#pragma once

#include "math/sampler.h"
#include "scene/scene_data.h"

namespace lumi::baker
{

inline constexpr int kMaxBounces = 64;
inline constexpr int kMaxScatterings = 1 << 16;  // far above the mean of any cloud: 4/3 of its optical radius

struct PathResult {
    bool covered = false;  // the ray meets the scene, or its volume by chance
    Rgb radiance;          // it comes along the ray; 0 if not covered
    // The part of it that a matt surface of the first one's colour would send: any direction of view sees it alike in
    // the mean. The rest may be negative.
    Rgb matt = {};
};

class Integrator
{
public:
    virtual ~Integrator() = default;
    // Draws from `sampler` after the caller has drawn what made the ray. Any number of threads may call it.
    virtual PathResult trace(const Ray& ray, Sampler& sampler) const = 0;
};

class PathTracer : public Integrator
{
public:
    explicit PathTracer(const SceneData& scene) : scene_(scene) {}  // borrows the scene
    PathResult trace(const Ray& ray, Sampler& sampler) const override;

private:
    const SceneData& scene_;
};

// Bakes call this before they start. It throws BakeError if the scene has a volume and the texels only know "covered"
// and "not covered": smoke would become a solid body.
void require_partial_coverage(const SceneData& scene, bool texels_have_it);

// Tells whether two bakes would trace the same: a hash of what some thousand fixed light paths bring home, to the last
// bit. Where it differs though the scenes are the same, the two builds or processors do not compute alike.
uint64_t tracing_fingerprint(const SceneData& scene);

}  // namespace lumi::baker
