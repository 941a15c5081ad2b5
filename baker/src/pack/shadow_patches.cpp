// SPDX-License-Identifier: MIT
#include "pack/shadow_patches.h"

#include <algorithm>
#include <cmath>

#include "mesh/edge_split.h"

namespace lumi::baker
{
namespace
{

// A shadow in pieces whose edges are no longer than the mesh's.
class ShadowPieces
{
public:
    ShadowPieces(const PartShadow& shadow, float longest_edge)
        : shadow_(shadow),
          across_(pieces_of(length(shadow.across), shadow.columns, longest_edge)),
          down_(pieces_of(length(shadow.down), shadow.rows, longest_edge))
    {
    }

    uint32_t count() const { return across_ * down_; }
    uint32_t vertices() const { return (across_ + 1) * (down_ + 1); }

    // `texels`: where the next rectangle begins.
    void add_to(FitShape& shape, FieldParts& parts, uint32_t& texels) const
    {
        const auto first = static_cast<uint32_t>(shape.mesh.positions.size());
        for (uint32_t y = 0; y <= down_; ++y)
            for (uint32_t x = 0; x <= across_; ++x) add_vertex(x, y, shape, parts);
        for (uint32_t y = 0; y < down_; ++y) {
            for (uint32_t x = 0; x < across_; ++x) {
                const uint32_t a = first + y * (across_ + 1) + x, c = a + across_ + 1;
                shape.mesh.patches.push_back({a, a + 1, c, c + 1});
                add_texels(x, y, shape, parts, texels);
            }
        }
    }

private:
    static uint32_t pieces_of(float side, uint32_t texels, float longest_edge)
    {
        const float pieces = std::ceil(side / std::max(longest_edge, 0.05f));
        return std::clamp(static_cast<uint32_t>(pieces), 1u, texels);
    }
    uint32_t column(uint32_t x) const { return shadow_.columns * x / across_; }
    uint32_t row(uint32_t y) const { return shadow_.rows * y / down_; }

    void add_vertex(uint32_t x, uint32_t y, FitShape& shape, FieldParts& parts) const
    {
        constexpr float kSteps = 1 << 14;  // of the format
        const float u = static_cast<float>(column(x)) / static_cast<float>(shadow_.columns),
                    v = static_cast<float>(row(y)) / static_cast<float>(shadow_.rows);
        const Vec3 p = shadow_.corner + shadow_.across * u + shadow_.down * v;
        const auto rounded = [](float c) { return std::round(c * kSteps) / kSteps; };
        const Vec3 normal = normalized(cross(shadow_.across, shadow_.down));
        shape.mesh.positions.push_back({rounded(p.x), rounded(p.y), rounded(p.z)});
        shape.mesh.normals.push_back(normal);
        shape.turns.push_back(view_turn(normal));
        parts.views.emplace_back();
    }

    void add_texels(uint32_t x, uint32_t y, FitShape& shape, FieldParts& parts, uint32_t& texels) const
    {
        const PatchRectangle r = {texels, column(x + 1) - column(x), row(y + 1) - row(y)};
        texels += r.size();
        shape.layout.rectangles.push_back(r);
        shape.layout.texels = std::max(shape.layout.texels, r.begin + detail::format::patch_reach(r.n));
        parts.texels.resize(shape.layout.texels);
        for (uint32_t k = 0; k < r.size(); ++k) {
            const uint32_t at = (row(y) + k / r.n) * shadow_.columns + column(x) + k % r.n;
            parts.texels[r.begin + k] = shadow_.passed[at];  // the palette's entry of that number
        }
    }

    const PartShadow& shadow_;
    const uint32_t across_, down_;
};

bool has_room(const FitShape& shape, const ShadowPieces& pieces)
{
    namespace format = detail::format;
    return shape.mesh.patches.size() + pieces.count() <= format::kMaxPatches &&
           shape.mesh.positions.size() + pieces.vertices() <= format::kMaxSurfaceVertices;
}

}  // namespace

std::vector<std::string> add_shadows(const std::vector<PartShadow>& shadows, FitShape& shape, FieldParts& parts)
{
    std::vector<std::string> notes;
    PatchMesh& mesh = shape.mesh;
    uint32_t texels = shape.layout.texels;
    for (const PartShadow& shadow : shadows) {
        const ShadowPieces pieces(shadow, mesh.longest_edge);
        if (!has_room(shape, pieces) || mesh.parts.size() == detail::format::kMaxParts) {
            notes.push_back("the part '" + mesh.parts[shadow.part].name +
                            "' casts no shadow: the field has no room for it");
            continue;
        }
        MovingPart follower = mesh.parts[shadow.part];
        follower.name.clear();
        follower.pivot = shadow.pivot;
        follower.follows = shadow.part + 1;
        follower.first_patch = static_cast<uint32_t>(mesh.patches.size());
        mesh.parts.push_back(follower);
        pieces.add_to(shape, parts, texels);
        mesh.see_through_patches += pieces.count();
        mesh.is_in_drawing_order = 1;
    }
    for (size_t k = 0; k < parts.see_through.size() && !shadows.empty(); ++k) {
        const auto share = static_cast<uint8_t>(k);
        parts.see_through[k] = {{0, 0, 0}, {share, share, share}};
    }
    return notes;
}

uint64_t most_shadow_bytes(size_t parts)
{
    namespace format = detail::format;
    constexpr uint64_t kSide = format::kMaxPatchSide, kMostTexels = kSide * kSide,
                       kReach = format::patch_reach(format::kMaxPatchSide);
    const uint64_t piece = format::kPatchBytes + format::kNeighbourBytes + 2 * format::kVertexBytes;
    return parts == 0 ? 0
                      : format::kSeeThroughBytes + kReach + parts * (format::kPartBytes + kMostTexels / 2 + 12 * piece);
}

}  // namespace lumi::baker
