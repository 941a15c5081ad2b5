// SPDX-License-Identifier: MIT
#include "volume/pieces.h"

#include <algorithm>
#include <numeric>

namespace lumi::baker
{
namespace
{

// Sets of vertices that are connected, each named by one of them.
class Sets
{
public:
    explicit Sets(size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), uint32_t{0}); }

    uint32_t name_of(uint32_t vertex)
    {
        while (parents_[vertex] != vertex) {
            parents_[vertex] = parents_[parents_[vertex]];
            vertex = parents_[vertex];
        }
        return vertex;
    }
    void connect(uint32_t a, uint32_t b) { parents_[name_of(a)] = name_of(b); }

private:
    std::vector<uint32_t> parents_;
};

std::vector<bool> kept_triangles(const Mesh& mesh, double least)
{
    Sets sets(mesh.positions.size());
    for (const Mesh::Corners& c : mesh.corners) {
        sets.connect(c[0], c[1]);
        sets.connect(c[0], c[2]);
    }
    std::vector<double> areas(mesh.positions.size(), 0);
    for (size_t t = 0; t < mesh.triangle_count(); ++t)
        areas[sets.name_of(mesh.corners[t][0])] += static_cast<double>(mesh.area(t));
    const double largest = *std::max_element(areas.begin(), areas.end());
    std::vector<bool> kept(mesh.triangle_count());
    for (size_t t = 0; t < kept.size(); ++t) kept[t] = areas[sets.name_of(mesh.corners[t][0])] >= least * largest;
    return kept;
}

// Leaves out positions that no triangle uses.
void compact(Mesh& mesh)
{
    constexpr uint32_t kUnused = ~uint32_t{0};
    std::vector<uint32_t> places(mesh.positions.size(), kUnused);
    std::vector<Vec3> positions;
    for (Mesh::Corners& corners : mesh.corners) {
        for (uint32_t& c : corners) {
            if (places[c] == kUnused) {
                places[c] = static_cast<uint32_t>(positions.size());
                positions.push_back(mesh.positions[c]);
            }
            c = places[c];
        }
    }
    mesh.positions = std::move(positions);
}

template <class T>
void keep(std::vector<T>& list, const std::vector<bool>& kept)
{
    size_t count = 0;
    for (size_t k = 0; k < kept.size(); ++k)
        if (kept[k]) list[count++] = list[k];
    list.resize(count);
}

}  // namespace

void keep_large_pieces(Mesh& mesh, double least)
{
    if (mesh.corners.empty()) return;
    const std::vector<bool> kept = kept_triangles(mesh, least);
    keep(mesh.corners, kept);
    keep(mesh.shading, kept);
    keep(mesh.mapping, kept);
    keep(mesh.materials, kept);
    compact(mesh);
}

}  // namespace lumi::baker
