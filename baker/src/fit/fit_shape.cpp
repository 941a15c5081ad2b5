// SPDX-License-Identifier: MIT
#include "fit/fit_shape.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lumi/baker/bake.h"
#include "lumi/surface/format.h"

namespace lumi::baker
{

namespace
{

constexpr float kInset = 1.0f / (1 << detail::format::kPatchInsetShift);

uint32_t side_of(float length, float texels_per_radius)
{
    const float side = std::round(length * texels_per_radius);
    return static_cast<uint32_t>(std::clamp(side, 1.0f, static_cast<float>(detail::format::kMaxPatchSide)));
}

PatchRectangle rectangle_of(const PatchMesh& mesh, const PatchMesh::Patch& p, float texels_per_radius)
{
    const Vec3 &a = mesh.positions[p.a], &b = mesh.positions[p.b], &c = mesh.positions[p.c];
    float across = length(b - a), down = length(c - a);
    if (p.d != PatchMesh::kNone) {
        const Vec3& d = mesh.positions[p.d];
        across = 0.5f * (across + length(d - c));
        down = 0.5f * (down + length(d - b));
    }
    return {0, side_of(across, texels_per_radius), side_of(down, texels_per_radius)};
}

// The wide ones first, so that little is needed after the last.
std::vector<uint32_t> widest_first(const std::vector<PatchRectangle>& rectangles)
{
    std::vector<uint32_t> order(rectangles.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](uint32_t a, uint32_t b) { return rectangles[a].n > rectangles[b].n; });
    return order;
}

uint32_t step_at(float coordinate, uint32_t side)
{
    return std::min(static_cast<uint32_t>(std::max(coordinate, 0.0f)), side - 1);
}

}  // namespace

TexelLayout layout_of(const PatchMesh& mesh, float texels_per_radius)
{
    return layout_of(mesh, std::vector<float>(mesh.patches.size(), texels_per_radius));
}

TexelLayout unlimited_layout(const PatchMesh& mesh, const std::vector<float>& densities)
{
    TexelLayout layout;
    for (size_t p = 0; p < mesh.patches.size(); ++p)
        layout.rectangles.push_back(rectangle_of(mesh, mesh.patches[p], densities[p]));
    uint32_t begin = 0;
    for (const uint32_t k : widest_first(layout.rectangles)) {
        PatchRectangle& r = layout.rectangles[k];
        r.begin = begin;
        begin += r.size();
        layout.texels = std::max(layout.texels, r.begin + detail::format::patch_reach(r.n));
    }
    layout.texels = std::max(layout.texels, begin);
    return layout;
}

TexelLayout layout_of(const PatchMesh& mesh, const std::vector<float>& densities)
{
    TexelLayout layout = unlimited_layout(mesh, densities);
    if (layout.texels > detail::format::kMaxSurfaceTexels) {
        throw BakeError("the field would hold " + std::to_string(layout.texels) +
                        " texels, and the format ends at 1048576; choose a smaller --texel-density");
    }
    return layout;
}

uint32_t texel_at(const PatchRectangle& r, bool second_triangle, float weight_of_second, float weight_of_third)
{
    const float n = static_cast<float>(r.n), m = static_cast<float>(r.m);
    const float u = kInset + (n - 2 * kInset) * weight_of_second, v = kInset + (m - 2 * kInset) * weight_of_third;
    const uint32_t x = step_at(second_triangle ? n - u : u, r.n), y = step_at(second_triangle ? m - v : v, r.m);
    return r.begin + y * r.n + x;
}

Vec2 place_in(const PatchRectangle& r, uint32_t texel, const Vec2& within)
{
    const auto weight = [](uint32_t step, float part, uint32_t side) {
        const float end = static_cast<float>(side) - kInset, low = std::max(static_cast<float>(step), kInset),
                    high = std::min(static_cast<float>(step + 1), end);
        return (low + part * (high - low) - kInset) / (end - kInset);
    };
    return {weight(texel % r.n, within.x, r.n), weight(texel / r.n, within.y, r.m)};
}

ViewTurn view_turn(const Vec3& normal)
{
    constexpr float kSteps = 127, kOpposite = 1e-3f;
    const Vec3 middle = normal + Vec3{0, 0, 1};
    const Vec3 h = length(middle) > kOpposite ? normalized(middle) : Vec3{1, 0, 0};
    const auto step = [](float v) { return static_cast<int8_t>(std::lround(v * kSteps)); };
    return {step(h.x), step(h.y), step(h.z)};
}

FitShape::FitShape(PatchMesh m, const std::vector<float>& densities, std::vector<SeeThroughTexel> of_see_through,
                   Gloss of_gloss)
    : mesh(std::move(m)),
      layout(layout_of(mesh, densities)),
      see_through(std::move(of_see_through)),
      gloss(std::move(of_gloss)),
      has_gloss(gloss.is_there() ? mesh.positions.size() : 0)
{
    see_through.resize(mesh.see_through_patches != 0 ? layout.texels : 0);  // a damaged shard may have others
    const auto step = [](float v) { return static_cast<int16_t>(std::lround(v * kEyeScale)); };
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vec3& p = mesh.positions[v];
        points.push_back({step(p.x), step(p.y), step(p.z)});
        turns.push_back(view_turn(gloss.is_there() ? gloss.normals[v] : mesh.normals[v]));
    }
    for (uint32_t p = 0; p < mesh.patches.size(); ++p)
        for (uint32_t corner = 0; gloss.has(p) && corner < 4; ++corner)
            if (const uint32_t v = vertex(p, corner); v != PatchMesh::kNone) has_gloss[v] = 1;
}

std::array<float, 3> FitShape::mirrored(uint32_t triangle, const Vec2& weights, const EyePoint& eye) const
{
    if (!gloss.has(triangle / 2)) return {};
    const GlossMap& map = gloss.maps[gloss.choices[triangle / 2] - 1];
    const float of_corners[3] = {1 - weights.x - weights.y, weights.x, weights.y};
    std::array<GlossCorner, 3> corners;
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t v = vertex(triangle / 2, patch_corner(triangle, k));
        corners[k] = {mesh.positions[v], gloss.normals[v], of_corners[k]};
    }
    const auto radii = [](int16_t v) { return static_cast<float>(v) / kEyeScale; };
    const GlossTaps taps = gloss_taps(corners, {radii(eye.x), radii(eye.y), radii(eye.z)});
    float steps = 0;
    for (size_t k = 0; k < taps.texels.size(); ++k) steps += taps.weights[k] * map.texel(taps.texels[k]);
    constexpr float kGainUnit = 64;
    return {steps * map.gains[0] / kGainUnit, steps * map.gains[1] / kGainUnit, steps * map.gains[2] / kGainUnit};
}

detail::ViewTaps FitShape::taps(uint32_t vertex, const EyePoint& eye) const
{
    const EyePoint& p = points[vertex];
    const ViewTurn& h = turns[vertex];
    const detail::ViewDirection local = detail::in_view_frame({eye.x - p.x, eye.y - p.y, eye.z - p.z}, h.x, h.y, h.z);
    return detail::view_taps(local.x, local.y, local.z);
}

}  // namespace lumi::baker
