// SPDX-License-Identifier: MIT
#include "pack/neighbours.h"

#include <map>
#include <tuple>

#include "lumi/surface/format.h"

namespace lumi::baker
{
namespace
{

using Place = std::tuple<float, float, float>;
using Edge = std::pair<Place, Place>;  // in the order of its triangle

Place place(const PatchMesh& mesh, uint32_t vertex)
{
    const Vec3& p = mesh.positions[vertex];
    return {p.x, p.y, p.z};
}

// The sides of a patch that have neighbours of their own, and the triangles that they belong to.
struct PatchSide {
    uint32_t from, to, triangle;
};

std::vector<PatchSide> patch_sides(const PatchMesh::Patch& p, uint32_t number)
{
    const uint32_t first = 2 * number, second = first + 1;
    if (p.d == PatchMesh::kNone) return {{p.a, p.b, first}, {p.c, p.a, first}, {p.b, p.c, first}};
    return {{p.a, p.b, first}, {p.c, p.a, first}, {p.d, p.c, second}, {p.b, p.d, second}};
}

}  // namespace

std::vector<std::array<uint16_t, 4>> neighbours_of(const PatchMesh& mesh)
{
    std::map<Edge, std::vector<uint32_t>> triangles;
    for (uint32_t k = 0; k < mesh.patches.size(); ++k)
        for (const PatchSide& side : patch_sides(mesh.patches[k], k))
            triangles[{place(mesh, side.from), place(mesh, side.to)}].push_back(side.triangle);
    std::vector<std::array<uint16_t, 4>> result;
    for (uint32_t k = 0; k < mesh.patches.size(); ++k) {
        std::array<uint16_t, 4> across;
        across.fill(static_cast<uint16_t>(format::kNoNeighbour));
        size_t at = 0;
        for (const PatchSide& side : patch_sides(mesh.patches[k], k)) {
            const auto found = triangles.find({place(mesh, side.to), place(mesh, side.from)});
            if (found != triangles.end() && found->second.size() == 1)
                across[at] = static_cast<uint16_t>(found->second.front());
            ++at;
        }
        result.push_back(across);
    }
    return result;
}

}  // namespace lumi::baker
