// SPDX-License-Identifier: MIT
// The rays of a field in the frame of the unit sphere: from a tangent disc at an origin point to a direction point.
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/accelerator.h"
#include "lumi/detail/lattice.h"
#include "math/frame.h"

namespace lumi::baker
{

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
    OriginDisc direction_disc(uint32_t j) const;  // the same at a direction point

    // The ray from `start` to `target`, where it ends: a start beside the sphere may see the target on the sphere's
    // near side, and what lies behind the target then belongs to another ray. Nothing if they coincide.
    static std::optional<Ray> ray(const Vec3& start, const Vec3& target);
    // The ray from `start` in the direction from `from` to `to`, without an end: what it meets lies on its own chord.
    // Nothing if they coincide.
    static std::optional<Ray> parallel_ray(const Vec3& start, const Vec3& from, const Vec3& to);

private:
    detail::Lattice origins_, directions_;
};

}  // namespace lumi::baker
