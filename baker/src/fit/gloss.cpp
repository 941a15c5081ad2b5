// SPDX-License-Identifier: MIT
#include "fit/gloss.h"

#include <algorithm>
#include <cmath>

#include "lumi/surface/format.h"
#include "mesh/patch_mesh.h"

namespace lumi::baker
{
namespace
{

constexpr int kSide = static_cast<int>(detail::format::kGlossSide);
constexpr float kLeastCosine = 0.25f, kLeastBack = 1.0f / 64;  // as in core

// The half vector along the frame's axes, whose normal leads to the eye.
Vec2 place_in_disc(const GlossCorner& corner, const Vec3& eye, const Frame& camera)
{
    const Vec3 to_eye = normalized(eye - corner.position);
    const float cosine = std::max(dot(corner.normal, to_eye), kLeastCosine);
    Vec3 half = camera.to_local(corner.normal * (2 * cosine) - to_eye + camera.normal);
    if (half.z < kLeastBack) half.z = 0;
    const float size = length(half);
    return size > 0 ? Vec2{half.x / size, half.y / size} : Vec2{0, 0};
}

Vec2 octahedral(const Vec3& d)
{
    const float sum = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
    const Vec2 place = {d.x / sum, d.y / sum};
    if (d.z >= 0) return place;
    return {std::copysign(1 - std::abs(place.y), d.x), std::copysign(1 - std::abs(place.x), d.y)};
}

}  // namespace

bool is_sound(const Gloss& gloss, const PatchMesh& mesh)
{
    if (!gloss.is_there()) return gloss.choices.empty() && gloss.normals.empty();
    const size_t maps = gloss.maps.size();
    const auto may_have = [&](uint32_t patch) { return patch < mesh.opaque_patches() && mesh.owner_of(patch) == 0; };
    for (uint32_t p = 0; p < gloss.choices.size(); ++p)
        if (gloss.choices[p] != 0 && !may_have(p)) return false;
    return mesh.is_matt == 0 && maps <= detail::format::kMaxGlossMaps && gloss.choices.size() == mesh.patches.size() &&
           gloss.normals.size() == mesh.positions.size() &&
           std::all_of(gloss.maps.begin(), gloss.maps.end(),
                       [](const GlossMap& m) { return m.texels.size() == detail::format::kGlossMapBytes; }) &&
           std::all_of(gloss.choices.begin(), gloss.choices.end(), [&](uint8_t c) { return c <= maps; }) &&
           std::all_of(gloss.normals.begin(), gloss.normals.end(), [](const Vec3& n) { return length(n) <= 1.01f; });
}

uint16_t gloss_texel(int column, int row)
{
    if (column < 0 || column >= kSide) {
        column = column < 0 ? -1 - column : 2 * kSide - 1 - column;
        row = kSide - 1 - row;
    }
    if (row < 0 || row >= kSide) {
        row = row < 0 ? -1 - row : 2 * kSide - 1 - row;
        column = kSide - 1 - column;
    }
    return static_cast<uint16_t>(row * kSide + column);
}

GlossTaps gloss_taps(const std::array<GlossCorner, 3>& corners, const Vec3& eye)
{
    const Frame camera(normalized(eye));
    Vec2 place = {0, 0};
    for (const GlossCorner& corner : corners) {
        const Vec2 p = place_in_disc(corner, eye, camera);
        place = {place.x + corner.weight * p.x, place.y + corner.weight * p.y};
    }
    const float back = std::sqrt(std::max(0.0f, 1 - place.x * place.x - place.y * place.y));
    const Vec2 o = octahedral(camera.to_world({2 * back * place.x, 2 * back * place.y, 2 * back * back - 1}));
    const float x = (o.x + 1) * kSide / 2 - 0.5f, y = (o.y + 1) * kSide / 2 - 0.5f;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const float right = x - static_cast<float>(column), down = y - static_cast<float>(row);
    return {{gloss_texel(column, row), gloss_texel(column + 1, row), gloss_texel(column, row + 1),
             gloss_texel(column + 1, row + 1)},
            {(1 - right) * (1 - down), right * (1 - down), (1 - right) * down, right * down}};
}

std::vector<uint8_t> bordered(const std::vector<uint8_t>& texels)
{
    std::vector<uint8_t> result;
    for (int row = -1; row <= kSide; ++row)
        for (int column = -1; column <= kSide; ++column) result.push_back(texels[gloss_texel(column, row)]);
    return result;
}

}  // namespace lumi::baker
