// SPDX-License-Identifier: MIT
// Estimates one texel: a pure function of scene, settings and the texel's place.
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/accelerator.h"
#include "image/palette.h"
#include "lumi/baker/chord.h"
#include "lumi/chord/format.h"
#include "lumi/detail/lattice.h"
#include "math/vec3.h"
#include "trace/error_gauge.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{

// Makes the rays of a field in the frame of the unit sphere: they go from a tangent disc at an origin point to a
// direction point.

// The disc that touches the sphere at a lattice point (an origin, unless said otherwise) and has that point's share of
// the sphere's area, 4π/M.
struct OriginDisc {
    Frame frame;  // normal: the origin point itself
    float radius;

    Vec3 at(const Vec2& u) const;  // uniform for u uniform in [0,1)²
};

class FieldRays
{
public:
    FieldRays(uint32_t origins, uint32_t directions) : origins_(origins), directions_(directions) {}

    OriginDisc disc(uint32_t i) const;
    Vec3 direction_point(uint32_t j) const;
    OriginDisc direction_disc(uint32_t j) const;  // the disc at a direction point

    // The ray from `start` to `target`, where it ends: a start beside the sphere may see the target on the sphere's
    // near side, and what lies behind the target then belongs to another ray. Nothing if they coincide.
    static std::optional<Ray> ray(const Vec3& start, const Vec3& target);
    // The ray from `start` in the direction from `from` to `to`, without an end: what it meets lies on its own chord.
    // Nothing if they coincide.
    static std::optional<Ray> parallel_ray(const Vec3& start, const Vec3& from, const Vec3& to);

private:
    detail::Lattice origins_, directions_;
};

class TexelTracer
{
public:
    TexelTracer(const SceneData& scene, const BakeSettings& settings);  // borrows the scene

    OriginDisc disc(uint32_t i) const { return rays_.disc(i); }
    // `disc` is disc(i), which a row shares. Any number of threads may call it.
    Estimate estimate(const OriginDisc& disc, uint32_t i, uint32_t j) const;

private:
    std::optional<Ray> ray(const OriginDisc& start, const OriginDisc& target, Sampler& sampler) const;
    bool enough(const ErrorGauge& gauge) const
    {
        return max_error_levels_ > 0 && gauge.settled(tone_, max_error_levels_);
    }

    ToneCurve tone_;
    uint64_t seed_;
    uint32_t samples_;
    float max_error_levels_;
    Footprint footprint_;
    Beam beam_;
    FieldRays rays_;
    PathTracer tracer_;
};

// Writes texel j of a row. `palette` is only read for palette8.
void encode_texel(TexelFormat format, const Palette& palette, const Estimate& estimate, uint8_t* row, uint32_t j);

}  // namespace lumi::baker
