// SPDX-License-Identifier: MIT
#include "mesh/seen_part.h"

#include "math/frame.h"
#include "math/sampler.h"
#include "math/warp.h"

namespace lumi::baker
{
namespace
{

constexpr uint32_t kRays = 2048;  // rays that a triangle gets before it counts as hidden
constexpr uint32_t kSeenTriangles = 64;
constexpr float kBeyondSphere = 2.5f;  // beyond the sphere from any place in it, in radii
constexpr uint64_t kSeenSeed = 0x7365656E;

Vec3 place_on(const Mesh& mesh, uint32_t triangle, const Vec2& weights)
{
    const Vec3& a = mesh.position(triangle, 0);
    return a + (mesh.position(triangle, 1) - a) * weights.x + (mesh.position(triangle, 2) - a) * weights.y;
}

bool is_seen(const MeshTracer& tracer, const ViewCap& cap, uint32_t triangle)
{
    const Vec3 area = tracer.mesh().area_vector(triangle);
    if (!(length(area) > 0)) return false;
    const Frame frame(normalized(area));
    Sampler sampler(kSeenSeed, triangle, 0);
    for (uint32_t k = 0; k < kRays; ++k) {
        sampler.start(k);
        const Vec3 place = place_on(tracer.mesh(), triangle, square_to_triangle(sampler.next_2d()));
        const Vec2 square = sampler.next_2d();
        const float side = tracer.two_sided() && k % 2 != 0 ? -1.0f : 1.0f;
        const Vec3 outwards = frame.to_world(direction_at(square.x, square.y) * side);
        const Ray ray = {place + outwards * kBeyondSphere, -outwards};
        const std::optional<Hit> hit = cap.sees(ray) ? tracer.closest(ray) : std::nullopt;
        if (hit && hit->triangle == triangle) return true;
    }
    return false;
}

}  // namespace

Mesh seen_part(const MeshTracer& tracer, Job& job, const ViewCap& cap)
{
    const uint32_t triangles = static_cast<uint32_t>(tracer.mesh().triangle_count());
    std::vector<uint8_t> seen(triangles);
    job.run((triangles + kSeenTriangles - 1) / kSeenTriangles, [&](uint32_t task) {
        const uint32_t end = std::min(triangles, (task + 1) * kSeenTriangles);
        for (uint32_t k = task * kSeenTriangles; k < end && !job.stopping(); ++k)
            seen[k] = is_seen(tracer, cap, k) ? 1 : 0;
    });
    Mesh result;
    result.positions = tracer.mesh().positions;
    for (uint32_t k = 0; k < triangles; ++k)
        if (seen[k] != 0) result.corners.push_back(tracer.mesh().corners[k]);
    return result;
}

}  // namespace lumi::baker
