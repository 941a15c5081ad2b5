// SPDX-License-Identifier: MIT
#include "mesh/mesh_tracer.h"

#include "math/sampler.h"
#include "math/vec3.h"
#include "math/warp.h"

namespace lumi::baker
{

MeshTracer::MeshTracer(Mesh mesh, Faces faces) : mesh_(std::move(mesh)), faces_(faces)
{
    if (mesh_.triangle_count() != 0) accelerator_.emplace(mesh_, faces);
}

std::optional<Hit> MeshTracer::closest(const Ray& ray) const
{
    return accelerator_ ? accelerator_->closest(ray) : std::nullopt;
}

std::optional<Hit> MeshTracer::near(const Ray& ray, float distance, float reach) const
{
    constexpr float kStep = 1e-4f;
    constexpr int kMostLayers = 32;
    std::optional<Hit> best;
    float from = std::max(0.0f, distance - reach);
    for (int k = 0; k < kMostLayers; ++k) {
        std::optional<Hit> hit = closest({ray.origin + ray.direction * from, ray.direction, distance + reach - from});
        if (!hit) break;
        hit->distance += from;
        from = hit->distance + kStep;
        if (!best || std::abs(hit->distance - distance) < std::abs(best->distance - distance)) best = hit;
    }
    return best;
}

namespace
{

constexpr uint32_t kSeenTriangles = 64;  // triangles of a task
constexpr float kBeyondSphere = 2.5f;    // radii from a place within the sphere to where its rays begin, outside of it
constexpr uint64_t kSeenSeed = 0x7365656E;

Vec3 place_on(const Mesh& mesh, uint32_t triangle, const Vec2& weights)
{
    const Vec3& a = mesh.position(triangle, 0);
    return a + (mesh.position(triangle, 1) - a) * weights.x + (mesh.position(triangle, 2) - a) * weights.y;
}

enum class SeenFrom : uint8_t { front, back };

bool is_seen(const MeshTracer& tracer, const ViewCap& cap, uint32_t triangle, SeenFrom side, uint32_t rays)
{
    const Vec3 area = tracer.mesh().area_vector(triangle);
    if (!(length(area) > 0)) return false;
    const Frame frame(normalized(area));
    const float outside = side == SeenFrom::front ? 1.0f : -1.0f;
    const uint32_t step = tracer.faces() == Faces::both ? 2 : 1;
    Sampler sampler(kSeenSeed, triangle, 0);
    for (uint32_t k = static_cast<uint32_t>(side); k < rays; k += step) {
        sampler.start(k);
        const Vec3 place = place_on(tracer.mesh(), triangle, square_to_triangle(sampler.next_2d()));
        const Vec2 square = sampler.next_2d();
        const Vec3 outwards = frame.to_world(direction_at(square.x, square.y) * outside);
        const Ray ray = {place + outwards * kBeyondSphere, -outwards};
        const std::optional<Hit> hit = cap.sees(ray) ? tracer.closest(ray) : std::nullopt;
        if (hit && hit->triangle == triangle) return true;
    }
    return false;
}

}  // namespace

Mesh seen_part(const MeshTracer& tracer, Job& job, const ViewCap& cap, uint32_t rays)
{
    struct Seen {
        bool front = false, back = false;
    };
    const Mesh& mesh = tracer.mesh();
    const uint32_t triangles = static_cast<uint32_t>(mesh.triangle_count());
    std::vector<Seen> seen(triangles);
    job.run((triangles + kSeenTriangles - 1) / kSeenTriangles, [&](uint32_t task) {
        const uint32_t end = std::min(triangles, (task + 1) * kSeenTriangles);
        for (uint32_t k = task * kSeenTriangles; k < end && !job.stopping(); ++k)
            seen[k] = {is_seen(tracer, cap, k, SeenFrom::front, rays),
                       tracer.faces() == Faces::both && is_seen(tracer, cap, k, SeenFrom::back, rays)};
    });
    Mesh result;
    result.positions = mesh.positions;
    for (uint32_t k = 0; k < triangles; ++k) {
        const Mesh::Corners& c = mesh.corners[k];
        if (seen[k].front) result.corners.push_back(c);
        if (seen[k].back) result.corners.push_back({c[0], c[2], c[1]});
    }
    return result;
}

}  // namespace lumi::baker
