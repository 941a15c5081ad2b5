// SPDX-License-Identifier: MIT
// The rays of an origin into the sphere: a ray's place in the unit disc is its direction, projected along the normal.
#pragma once

#include "geometry/accelerator.h"
#include "lumi/lattice.h"

namespace lumi::baker
{

class InwardRays
{
public:
    InwardRays(const Lattice& origins, uint32_t origin);

    const Vec3& origin() const { return origin_; }
    Ray ray(const Vec2& place) const;
    // Where a direction lies in the disc.
    Vec2 place(const Vec3& direction) const { return {dot(tangent_, direction), dot(bitangent_, direction)}; }

private:
    Vec3 origin_, tangent_, bitangent_;
};

}  // namespace lumi::baker
