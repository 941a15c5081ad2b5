// SPDX-License-Identifier: MIT
#include "fit/fit_shape.h"

#include <cmath>

namespace lumi::baker
{

ViewTurn view_turn(const Vec3& normal)
{
    constexpr float kSteps = 127, kOpposite = 1e-3f;
    const Vec3 middle = normal + Vec3{0, 0, 1};
    const Vec3 h = length(middle) > kOpposite ? normalized(middle) : Vec3{1, 0, 0};
    const auto step = [](float v) { return static_cast<int8_t>(std::lround(v * kSteps)); };
    return {step(h.x), step(h.y), step(h.z)};
}

FitShape::FitShape(PatchMesh m, const std::vector<float>& densities, std::vector<SeeThroughTexel> of_see_through)
    : mesh(std::move(m)), layout(layout_of(mesh, densities)), see_through(std::move(of_see_through))
{
    see_through.resize(mesh.see_through_patches != 0 ? layout.texels : 0);  // a damaged shard may have others
    const auto step = [](float v) { return static_cast<int16_t>(std::lround(v * kEyeScale)); };
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vec3& p = mesh.positions[v];
        points.push_back({step(p.x), step(p.y), step(p.z)});
        turns.push_back(view_turn(mesh.normals[v]));
    }
}

detail::ViewTaps FitShape::taps(uint32_t vertex, const EyePoint& eye) const
{
    const EyePoint& p = points[vertex];
    const ViewTurn& h = turns[vertex];
    const detail::ViewDirection local = detail::in_view_frame({eye.x - p.x, eye.y - p.y, eye.z - p.z}, h.x, h.y, h.z);
    return detail::view_taps(local.x, local.y, local.z);
}

}  // namespace lumi::baker
