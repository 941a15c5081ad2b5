// SPDX-License-Identifier: MIT
#include "emitters.h"

#include "warp.h"

namespace lumi::baker
{

Emitters::Emitters(const Mesh& mesh, const std::vector<Material>& materials) : mesh_(mesh), materials_(materials)
{
    double sum = 0;
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        if (materials[mesh.materials[t]].emits()) {
            triangles_.push_back(static_cast<uint32_t>(t));
            sum += static_cast<double>(mesh.area(t)) * static_cast<double>(brightness(triangles_.back()));
            cumulative_.push_back(sum);
        }
    }
}

float Emitters::brightness(uint32_t triangle) const
{
    return max_component(materials_[mesh_.materials[triangle]].emission);
}

float Emitters::power() const
{
    return cumulative_.empty() ? 0.0f : static_cast<float>(cumulative_.back()) * 2 * kPi;
}

float Emitters::pdf(uint32_t triangle, const Vec3& direction, float distance) const
{
    const Vec3 normal = normalized(mesh_.area_vector(triangle));
    const float cosine = std::abs(dot(normal, direction));
    const float per_area = brightness(triangle) / static_cast<float>(cumulative_.back());
    return cosine > 0 ? per_area * distance * distance / cosine : 0.0f;
}

LightSample Emitters::sample(const Vec3& from, float u_select, const Vec2& u) const
{
    const double target = static_cast<double>(u_select) * cumulative_.back();
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, target);
    const uint32_t triangle = triangles_[static_cast<size_t>(found - cumulative_.begin())];
    const Vec2 b = square_to_triangle(u);
    const Vec3 point = mesh_.position(triangle, 0) * (1 - b.x - b.y) + mesh_.position(triangle, 1) * b.x +
                       mesh_.position(triangle, 2) * b.y;
    const Vec3 towards = point - from;
    const float distance = length(towards);
    if (!(distance > 0)) {
        return {};
    }
    const Vec3 direction = towards / distance;
    return {direction, distance, materials_[mesh_.materials[triangle]].emission, pdf(triangle, direction, distance)};
}

}  // namespace lumi::baker
