// SPDX-License-Identifier: MIT
#include "mesh/mesh_tracer.h"

namespace lumi::baker
{
namespace
{

constexpr float kPastFace = 2e-6f;  // past a back face; a few units in the last place at length 1
constexpr int kMaxBackFaces = 256;

}  // namespace

MeshTracer::MeshTracer(Mesh mesh, bool two_sided) : mesh_(std::move(mesh)), two_sided_(two_sided)
{
    if (mesh_.triangle_count() != 0) accelerator_.emplace(mesh_);
}

std::optional<Hit> MeshTracer::closest(const Ray& ray) const
{
    if (!accelerator_) return std::nullopt;
    float passed = 0;
    for (int k = 0; k < kMaxBackFaces; ++k) {
        std::optional<Hit> hit = accelerator_->closest({ray.origin + ray.direction * passed, ray.direction, ray.end});
        if (!hit) return std::nullopt;
        if (two_sided_ || dot(mesh_.area_vector(hit->triangle), ray.direction) < 0) {
            hit->distance += passed;
            return hit;
        }
        passed += hit->distance + kPastFace;
    }
    return std::nullopt;
}

}  // namespace lumi::baker
