// SPDX-License-Identifier: MIT
#include "pack/patch_neighbours.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <tuple>

namespace lumi::baker
{
namespace
{

using detail::format::kCrease;
using detail::format::kNoNeighbour;

using Place = std::tuple<float, float, float>;
using Edge = std::pair<Place, Place>;  // from one to the other, as its triangle winds

Place place(const PatchMesh& mesh, uint32_t vertex)
{
    const Vec3& p = mesh.positions[vertex];
    return {p.x, p.y, p.z};
}

// A side of a patch that has a neighbour of its own: its vertices as its triangle winds, the triangle's third vertex,
// and the triangle's number.
struct PatchSide {
    uint32_t from, to, opposite, triangle;
};

std::vector<PatchSide> patch_sides(const PatchMesh::Patch& p, uint32_t number)
{
    const uint32_t first = 2 * number, second = first + 1;
    if (p.d == PatchMesh::kNone) return {{p.a, p.b, p.c, first}, {p.c, p.a, p.b, first}, {p.b, p.c, p.a, first}};
    return {{p.a, p.b, p.c, first}, {p.c, p.a, p.b, first}, {p.d, p.c, p.b, second}, {p.b, p.d, p.c, second}};
}

using SidesByEdge = std::map<Edge, std::vector<PatchSide>>;

// The side of the triangle across; null where the mesh ends, or where more than two triangles meet. A triangle that is
// the back of the side's own one shares its third vertex: it lies on the same edge, but not across it.
const PatchSide* across(const PatchMesh& mesh, const SidesByEdge& sides, const PatchSide& side)
{
    const auto found = sides.find({place(mesh, side.to), place(mesh, side.from)});
    if (found == sides.end()) return nullptr;
    const PatchSide* result = nullptr;
    for (const PatchSide& other : found->second) {
        if (place(mesh, other.opposite) == place(mesh, side.opposite)) continue;
        if (result != nullptr) return nullptr;
        result = &other;
    }
    return result;
}

std::array<int, 3> mean_levels(const GlossMap& map)
{
    constexpr uint32_t kTexels = detail::format::kGlossSide * detail::format::kGlossSide;
    int sum = 0;
    for (uint32_t k = 0; k < kTexels; ++k) sum += map.texel(k);
    const auto level = [&](uint8_t gain) { return gain * sum / static_cast<int>(kTexels) / GlossMap::kGainUnit; };
    return {level(map.gains[0]), level(map.gains[1]), level(map.gains[2])};
}

// Finds the sides along which colours differ.
class Creases
{
public:
    Creases(const FitShape& shape, const FieldParts& parts) : shape_(shape), parts_(parts)
    {
        for (const GlossMap& map : shape.gloss.maps) means_.push_back(mean_levels(map));
    }

    // Whether the mean colours on both sides differ so much that stairs would show, and by more than a texel does from
    // the next one inwards: where texels are coarse or full of detail, what differs is none of the surface's own.
    bool is_one(const PatchSide& side, const PatchSide& other) const
    {
        constexpr int kPlaces = 8, kLeast = 24;  // levels of the channel that differs most
        constexpr int kSteeper = 2;
        std::array<int, 3> sum{};
        int detail = 0;
        for (int k = 0; k < kPlaces; ++k) {
            const float along = (static_cast<float>(k) + 0.5f) / kPlaces;
            const Rgb8 &own = colour(side, along, 0), &beyond = colour(other, 1 - along, 0);
            sum[0] += own.r - beyond.r;
            sum[1] += own.g - beyond.g;
            sum[2] += own.b - beyond.b;
            detail +=
                std::max(difference(own, colour(side, along, 1)), difference(beyond, colour(other, 1 - along, 1)));
        }
        const std::array<int, 3> own = mean_of_gloss(side), beyond = mean_of_gloss(other);
        for (size_t c = 0; c < 3; ++c) sum[c] += kPlaces * (own[c] - beyond[c]);
        const int most = std::max({std::abs(sum[0]), std::abs(sum[1]), std::abs(sum[2])});
        return most >= kPlaces * kLeast && most >= kSteeper * detail;
    }

private:
    // Returns what a patch's map adds to its texels in the mean.
    std::array<int, 3> mean_of_gloss(const PatchSide& side) const
    {
        const uint8_t choice = means_.empty() ? 0 : shape_.gloss.choices[side.triangle / 2];
        return choice == 0 ? std::array<int, 3>{} : means_[choice - 1u];
    }

    // Texels from the rectangle's corner (0, 0).
    Vec2 corner(uint32_t patch, uint32_t vertex) const
    {
        const PatchMesh::Patch& p = shape_.mesh.patches[patch];
        const PatchRectangle& r = shape_.layout.rectangles[patch];
        return {vertex == p.b || vertex == p.d ? static_cast<float>(r.n) : 0.0f,
                vertex == p.c || vertex == p.d ? static_cast<float>(r.m) : 0.0f};
    }

    static int difference(const Rgb8& a, const Rgb8& b)
    {
        return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
    }

    // The texel at the rim there, or so many further in.
    const Rgb8& colour(const PatchSide& side, float along, int inwards) const
    {
        const uint32_t patch = side.triangle / 2;
        const PatchRectangle& r = shape_.layout.rectangles[patch];
        const Vec2 from = corner(patch, side.from), to = corner(patch, side.to);
        const auto place = [&](float begin, float end, uint32_t count, bool is_diagonal) {
            const int at = std::min(static_cast<int>(begin + along * (end - begin)), static_cast<int>(count) - 1);
            const int step = begin == end ? (begin == 0 ? inwards : -inwards) : is_diagonal ? -inwards : 0;
            return static_cast<uint32_t>(std::clamp(at + step, 0, static_cast<int>(count) - 1));
        };
        const bool is_diagonal = from.x != to.x && from.y != to.y;
        const uint32_t column = place(from.x, to.x, r.n, is_diagonal), row = place(from.y, to.y, r.m, is_diagonal);
        return parts_.palette[parts_.texels[r.begin + row * r.n + column]];
    }

    const FitShape& shape_;
    const FieldParts& parts_;
    std::vector<std::array<int, 3>> means_;  // of gloss maps
};

// Adds those of patches from `first` up to `end`. Vertices at one place are one here, whatever their normals.
void add_neighbours(const PatchMesh& mesh, uint32_t first, uint32_t end, const Creases& creases,
                    std::vector<std::array<uint16_t, 4>>& result)
{
    SidesByEdge sides;
    for (uint32_t k = first; k < end; ++k)
        for (const PatchSide& side : patch_sides(mesh.patches[k], k))
            sides[{place(mesh, side.from), place(mesh, side.to)}].push_back(side);
    for (uint32_t k = first; k < end; ++k) {
        std::array<uint16_t, 4> neighbours;
        neighbours.fill(kNoNeighbour);
        size_t at = 0;
        for (const PatchSide& side : patch_sides(mesh.patches[k], k)) {
            uint16_t& word = neighbours[at++];
            const PatchSide* const other = across(mesh, sides, side);
            if (other == nullptr) continue;
            word = static_cast<uint16_t>(other->triangle);
            const bool is_crease =
                k < mesh.opaque_patches() && side.triangle < other->triangle && creases.is_one(side, *other);
            if (is_crease) word = static_cast<uint16_t>(word | kCrease);
        }
        result.push_back(neighbours);
    }
}

// The first opaque patch of the body and of each part, and the end of the last.
std::vector<uint32_t> owner_ends(const PatchMesh& mesh)
{
    std::vector<uint32_t> ends = {0};
    for (const MovingPart& part : mesh.parts)
        if (part.follows == 0) ends.push_back(part.first_patch);
    ends.push_back(mesh.opaque_patches());
    return ends;
}

}  // namespace

bool is_shadow(const PatchMesh& mesh, uint32_t patch)
{
    return patch < mesh.opaque_patches() + mesh.ground_patches || mesh.owner_of(patch) != 0;
}

std::vector<std::array<uint16_t, 4>> patch_neighbours(const FitShape& shape, const FieldParts& parts)
{
    const PatchMesh& mesh = shape.mesh;
    std::vector<uint32_t> ends = owner_ends(mesh);
    ends.push_back(static_cast<uint32_t>(mesh.patches.size()));
    std::vector<std::array<uint16_t, 4>> result;
    const Creases creases(shape, parts);
    for (size_t k = 1; k < ends.size(); ++k) add_neighbours(mesh, ends[k - 1], ends[k], creases, result);
    for (uint32_t p = mesh.opaque_patches(); p < result.size(); ++p)
        for (uint32_t side = 0; is_shadow(mesh, p) && side < 4; ++side)
            if (result[p][side] == kNoNeighbour) result[p][side] = static_cast<uint16_t>(2 * p + side / 2);
    return result;
}

}  // namespace lumi::baker
