// SPDX-License-Identifier: MIT
#include "fit/extra_lines.h"

#include <algorithm>
#include <cmath>

#include "math/vec3.h"
#include "math/warp.h"

namespace lumi::baker
{

std::vector<float> patch_areas(const PatchMesh& mesh)
{
    std::vector<uint32_t> numbers;
    const Mesh triangles = all_triangles(mesh, numbers);
    std::vector<float> areas(mesh.patches.size(), 0);
    for (uint32_t k = 0; k < numbers.size(); ++k) areas[numbers[k] / 2] += triangles.area(k);
    return areas;
}

ExtraLines::ExtraLines(const FitShape& shape, const std::vector<float>& chances)
{
    if (chances.empty()) return;
    triangles_ = all_triangles(shape.mesh, numbers_);
    const std::vector<float> areas = patch_areas(shape.mesh);
    float end = 0;
    for (uint32_t k = 0; k < numbers_.size(); ++k) {
        const uint32_t patch = numbers_[k] / 2;
        if (areas[patch] > 0) end += chances[patch] * triangles_.area(k) / areas[patch];
        ends_.push_back(end);
    }
}

ExtraLines::Line ExtraLines::draw(Sampler& sampler) const
{
    const float at = sampler.next_1d() * ends_.back();
    const auto above = std::upper_bound(ends_.begin(), ends_.end() - 1, at);
    const auto triangle = static_cast<uint32_t>(above - ends_.begin());
    const Vec2 w = square_to_triangle(sampler.next_2d());
    const Vec3& a = triangles_.position(triangle, 0);
    const Vec3 place = a + (triangles_.position(triangle, 1) - a) * w.x + (triangles_.position(triangle, 2) - a) * w.y;
    const Frame frame(normalized(triangles_.area_vector(triangle)));
    const Vec3 outwards = frame.to_world(square_to_cosine_hemisphere(sampler.next_2d()));
    const float along = dot(place, outwards);
    const float out = std::sqrt(std::max(0.0f, along * along + 1 - dot(place, place))) - along;
    return {{place + outwards * out, -outwards}, numbers_[triangle] / 2};
}

}  // namespace lumi::baker
