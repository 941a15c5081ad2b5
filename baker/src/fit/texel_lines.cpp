// SPDX-License-Identifier: MIT
#include "fit/texel_lines.h"

#include <cmath>

#include "math/vec3.h"
#include "math/warp.h"

namespace lumi::baker
{
namespace
{

struct Triangle {
    Vec3 first, across, down;  // a corner, and from there to the others

    Vec3 at(const Vec2& weights) const { return first + across * weights.x + down * weights.y; }
};

Triangle triangle_of(const FitShape& shape, uint32_t triangle)
{
    const Vec3& first = shape.position(triangle, 0);
    return {first, shape.position(triangle, 1) - first, shape.position(triangle, 2) - first};
}

}  // namespace

std::optional<Ray> texel_line(const FitShape& shape, uint32_t patch, uint32_t texel, Sampler& sampler)
{
    const PatchRectangle& r = shape.layout.rectangles[patch];
    const Vec2 within = sampler.next_2d(), towards = sampler.next_2d();
    Vec2 weights = place_in(r, texel, within);
    const bool second = weights.x + weights.y > 1;
    if (second && shape.vertex(patch, 3) == PatchMesh::kNone) return std::nullopt;
    if (second) weights = {1 - weights.x, 1 - weights.y};
    const Triangle triangle = triangle_of(shape, 2 * patch + (second ? 1 : 0));
    const Vec3 normal = cross(triangle.across, triangle.down);
    if (!(dot(normal, normal) > 0)) return std::nullopt;
    const Vec3 place = triangle.at(weights);
    const Vec3 outwards = Frame(normalized(normal)).to_world(square_to_cosine_hemisphere(towards));
    const float along = dot(place, outwards);
    const float out = std::sqrt(std::max(0.0f, along * along + 1 - dot(place, place))) - along;
    return Ray{place + outwards * out, -outwards};
}

}  // namespace lumi::baker
