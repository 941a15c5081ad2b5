// SPDX-License-Identifier: MIT
// An orthonormal frame around a unit vector, continuous but for one seam and exact at the poles.
// Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
#pragma once

#include "math/vec3.h"

namespace lumi::baker
{

struct Frame {
    Vec3 tangent, bitangent, normal;

    explicit Frame(const Vec3& n) : normal(n)
    {
        const float sign = std::copysign(1.0f, n.z);
        const float a = -1 / (sign + n.z);
        const float b = n.x * n.y * a;
        tangent = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
        bitangent = {b, sign + n.y * n.y * a, -n.y};
    }

    // With the tangent as near to `along` as can be; any tangent where `along` is not across n.
    Frame(const Vec3& n, const Vec3& along) : Frame(n)
    {
        const Vec3 across = along - n * dot(n, along);
        const float size = length(across);
        if (size > 0) {
            tangent = across / size;
            bitangent = cross(n, tangent);
        }
    }

    Vec3 to_local(const Vec3& v) const { return {dot(v, tangent), dot(v, bitangent), dot(v, normal)}; }
    Vec3 to_world(const Vec3& v) const { return tangent * v.x + bitangent * v.y + normal * v.z; }
};

}  // namespace lumi::baker
