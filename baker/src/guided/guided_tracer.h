// SPDX-License-Identifier: MIT
// The texels and mean colours of guided fields, estimated: pure functions of scene, settings and place.
#pragma once

#include "guided/chart_geometry.h"
#include "guided/chart_palettes.h"
#include "guided/guided_parts.h"
#include "guided/mean_voxels.h"
#include "proxy/proxy_tracer.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{

// The mean that texels are differences from.
struct MeanColour {
    const NodeGrid& grid;
    const std::vector<Levels>& colours;
};

struct ColourAtPoint {
    Vec3 x;
    Levels colour;
};

struct TexelEstimate {
    Levels levels;
    bool known = false;
    float farthest = 0;  // distance at which the origin sees the surface here; 0: it sees none
};

class GuidedTracer
{
public:
    // Borrows all. `proxy` is null for a focus surface.
    GuidedTracer(const SceneData& scene, const ProxyTracer* proxy, uint32_t samples, float jitter, uint64_t seed);

    // Point k of an origin: the surface at a random place in the cell of grid point (u, v), by `paths` light paths.
    std::optional<ColourAtPoint> point(const ChartGeometry& chart, uint32_t origin, uint32_t k, const Vec2& grid_point,
                                       uint32_t paths) const;
    // The colour of a grid point, less the mean where there is one.
    TexelEstimate texel(const ChartGeometry& chart, uint32_t origin, uint32_t u, uint32_t v,
                        const MeanColour* mean) const;

private:
    // Where a ray meets the shared surface; nothing where it meets none.
    std::optional<float> surface(const Ray& ray) const;
    // The light along a ray if what it meets is the shared surface.
    std::optional<Rgb> light(const Ray& ray, float surface, Sampler& sampler) const;
    Levels encoded(const Rgb& sum, uint32_t count) const;

    const SceneData& scene_;
    const ProxyTracer* proxy_;
    PathTracer tracer_;
    uint32_t samples_;
    float jitter_;
    uint64_t seed_;
};

}  // namespace lumi::baker
