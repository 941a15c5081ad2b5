// SPDX-License-Identifier: MIT
// An origin's chart in floating point: grid points to rays and surface points to grid points (lumi/guided_format.h).
#pragma once

#include <optional>

#include "proxy/inward_rays.h"

namespace lumi::baker
{

class ChartGeometry
{
public:
    ChartGeometry(const Lattice& origins, uint32_t origin, uint32_t chart_size);

    const Vec3& origin() const { return rays_.origin(); }
    // Grid points lie in 0 .. side() - 1.
    uint32_t side() const { return side_; }
    // The ray of a place in the grid; nothing beside the disc.
    std::optional<Ray> ray(const Vec2& place) const;
    // The ray of a place in the unit disc.
    Ray ray_in_disc(const Vec2& ab) const { return rays_.ray(ab); }
    // Where the ray to X lies in the grid.
    Vec2 place(const Vec3& x) const;
    // A step of length 1 in the disc's plane along (da, db), in grid coordinates.
    Vec2 grid_step(const Vec2& ab) const;
    // The radius in the disc of the circle that has a grid point's share of the area.
    float cell_radius() const;

private:
    InwardRays rays_;
    float half_size_, centre_;
    uint32_t side_;
};

}  // namespace lumi::baker
