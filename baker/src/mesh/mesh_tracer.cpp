// SPDX-License-Identifier: MIT
#include "mesh/mesh_tracer.h"

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

}  // namespace lumi::baker
