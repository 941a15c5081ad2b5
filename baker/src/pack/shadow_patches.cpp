// SPDX-License-Identifier: MIT
#include "pack/shadow_patches.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/edge_split.h"

namespace lumi::baker
{
namespace
{

void add_plain_vertex(const Vec3& position, const Vec3& normal, FitShape& shape, FieldParts& parts)
{
    shape.mesh.positions.push_back(position);
    shape.mesh.normals.push_back(normal);
    shape.turns.push_back(view_turn(normal));
    parts.views.emplace_back();
}

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
        add_plain_vertex({rounded(p.x), rounded(p.y), rounded(p.z)}, normalized(cross(shadow_.across, shadow_.down)),
                         shape, parts);
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

bool has_room(const FitShape& shape, size_t patches, size_t vertices)
{
    namespace format = detail::format;
    return shape.mesh.patches.size() + patches <= format::kMaxPatches &&
           shape.mesh.positions.size() + vertices <= format::kMaxSurfaceVertices;
}

constexpr size_t kLevelsBesidePanes = 64;  // of the palette: steps of 4 levels

// The pieces of a ground that are not clear.
class GroundPieces
{
public:
    explicit GroundPieces(const GroundShadow& shadow)
        : shadow_(shadow), vertices_((shadow.pieces + 1) * (shadow.pieces + 1))
    {
        for (uint32_t p = 0; p < shadow.pieces * shadow.pieces; ++p) {
            const auto first = shadow.passed.begin() + static_cast<ptrdiff_t>(p * texels());
            const bool is_clear = std::all_of(first, first + static_cast<ptrdiff_t>(texels()),
                                              [](uint8_t passed) { return passed == UINT8_MAX; });
            if (!is_clear) shown_.push_back(p);
        }
    }

    size_t count() const { return shown_.size(); }
    size_t vertices() const { return vertices_.size(); }

    // `first`: of the see-through palette's entries.
    void add_to(FitShape& shape, FieldParts& parts, size_t first, size_t levels)
    {
        const auto at = static_cast<ptrdiff_t>(shape.mesh.opaque_patches());
        std::vector<PatchMesh::Patch> patches;
        std::vector<PatchRectangle> rectangles;
        uint32_t texel = shape.layout.texels;
        for (const uint32_t p : shown_) {
            const uint32_t x = p % shadow_.pieces, y = p / shadow_.pieces;
            patches.push_back({vertex(x, y, shape, parts), vertex(x + 1, y, shape, parts),
                               vertex(x, y + 1, shape, parts), vertex(x + 1, y + 1, shape, parts)});
            measure(patches.back(), shape.mesh);
            rectangles.push_back({texel, shadow_.side, shadow_.side});
            parts.texels.resize(texel + texels());
            for (size_t k = 0; k < texels(); ++k)
                parts.texels[texel + k] = static_cast<uint8_t>(
                    first + (shadow_.passed[p * texels() + k] * (levels - 1) + UINT8_MAX / 2) / UINT8_MAX);
            shape.layout.texels = std::max(shape.layout.texels, texel + detail::format::patch_reach(shadow_.side));
            texel += static_cast<uint32_t>(texels());
        }
        parts.texels.resize(shape.layout.texels);
        shape.mesh.patches.insert(shape.mesh.patches.begin() + at, patches.begin(), patches.end());
        shape.layout.rectangles.insert(shape.layout.rectangles.begin() + at, rectangles.begin(), rectangles.end());
        shape.mesh.see_through_patches += static_cast<uint32_t>(patches.size());
        shape.mesh.ground_patches = static_cast<uint32_t>(patches.size());
    }

private:
    size_t texels() const { return size_t{shadow_.side} * shadow_.side; }

    uint32_t vertex(uint32_t x, uint32_t y, FitShape& shape, FieldParts& parts)
    {
        std::optional<uint32_t>& known = vertices_[size_t{y} * (shadow_.pieces + 1) + x];
        if (!known) {
            known = static_cast<uint32_t>(shape.mesh.positions.size());
            add_plain_vertex(shadow_.corner(x, y), {0, 0, 1}, shape, parts);
        }
        return *known;
    }

    static void measure(const PatchMesh::Patch& p, PatchMesh& mesh)
    {
        for (const auto& [from, to] :
             {std::pair(p.a, p.b), std::pair(p.a, p.c), std::pair(p.b, p.c), std::pair(p.b, p.d), std::pair(p.c, p.d)})
            mesh.longest_edge = std::max(mesh.longest_edge, length(mesh.positions[from] - mesh.positions[to]));
    }

    const GroundShadow& shadow_;
    std::vector<uint32_t> shown_;
    std::vector<std::optional<uint32_t>> vertices_;  // by corner of pieces
};

}  // namespace

std::vector<std::string> add_shadows(const std::vector<PartShadow>& shadows, FitShape& shape, FieldParts& parts)
{
    std::vector<std::string> notes;
    PatchMesh& mesh = shape.mesh;
    uint32_t texels = shape.layout.texels;
    for (const PartShadow& shadow : shadows) {
        const ShadowPieces pieces(shadow, mesh.longest_edge);
        if (!has_room(shape, pieces.count(), pieces.vertices()) || mesh.parts.size() == detail::format::kMaxParts) {
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

size_t ground_levels(const GroundShadow& shadow, const PatchMesh& mesh)
{
    const bool is_beside = mesh.see_through_patches != 0;
    return !shadow.is_there() ? 0 : is_beside ? kLevelsBesidePanes : detail::format::kPaletteEntries;
}

std::vector<std::string> add_ground(const GroundShadow& shadow, FitShape& shape, FieldParts& parts)
{
    const size_t levels = ground_levels(shadow, shape.mesh), first = parts.see_through.size() - levels;
    if (levels == 0) return shadow.notes;
    GroundPieces pieces(shadow);
    if (pieces.count() == 0) return {"the ground has no shadow: it is too faint to be seen"};
    if (!has_room(shape, pieces.count(), pieces.vertices()))
        return {"the ground has no shadow: the field has no room for it"};
    if (shape.mesh.see_through_patches == 0) shape.mesh.is_in_drawing_order = 1;
    pieces.add_to(shape, parts, first, levels);
    for (size_t k = 0; k < levels; ++k) {
        const auto share = static_cast<uint8_t>((k * UINT8_MAX + (levels - 1) / 2) / (levels - 1));
        parts.see_through[first + k] = {{0, 0, 0}, {share, share, share}};
    }
    return {};
}

GroundRoom most_ground_room(float longest_edge, float texels_per_radius)
{
    namespace format = detail::format;
    const GroundGrid grid = ground_grid(longest_edge, texels_per_radius);
    const uint32_t patches = grid.pieces * grid.pieces, vertices = (grid.pieces + 1) * (grid.pieces + 1);
    const uint64_t texels = uint64_t{patches} * grid.side * grid.side + format::patch_reach(grid.side);
    return {vertices, patches,
            vertices * uint64_t{format::kVertexBytes} +
                patches * uint64_t{format::kPatchBytes + format::kNeighbourBytes} + texels};
}

uint64_t most_shadow_bytes(size_t parts, uint32_t texels)
{
    namespace format = detail::format;
    constexpr uint64_t kPieces = 12, kPiece = format::kPatchBytes + format::kNeighbourBytes + 2 * format::kVertexBytes;
    const uint32_t most = most_shadow_texels(texels);
    const auto columns = static_cast<uint32_t>(std::ceil(std::sqrt(most)));  // no more than rows
    const uint64_t reach = format::patch_reach(std::min(columns, format::kMaxPatchSide));
    const uint64_t shadow = format::kPartBytes + most + kPieces * kPiece;
    return parts == 0 ? 0 : format::kSeeThroughBytes + reach + parts * shadow;
}

}  // namespace lumi::baker
