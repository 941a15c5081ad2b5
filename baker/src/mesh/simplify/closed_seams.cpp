// SPDX-License-Identifier: MIT
#include "mesh/simplify/steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "geometry/components.h"

namespace lumi::baker
{
namespace
{

constexpr float kLeastReach = 1e-6f;  // positions of floats are no finer; cells have 21 bits a coordinate

// Vertices by cells of space, as large as the reach: what is near lies in the cell or beside it.
class Cells
{
public:
    explicit Cells(float size) : size_(size) {}

    void add(const Vec3& place, uint32_t vertex) { cells_[key(cell(place, 0, 0, 0))].push_back(vertex); }

    // Calls with the vertices of each cell around a place, as they were added, until that returns true; whether it did.
    template <class Use>
    bool any_around(const Vec3& place, const Use& use) const
    {
        for (int k = 0; k < 27; ++k) {
            const auto found = cells_.find(key(cell(place, k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1)));
            if (found != cells_.end() && use(found->second)) return true;
        }
        return false;
    }

private:
    using Cell = std::array<int32_t, 3>;

    Cell cell(const Vec3& p, int x, int y, int z) const
    {
        const auto step = [&](float c) { return static_cast<int32_t>(std::floor(c / size_)); };
        return {step(p.x) + x, step(p.y) + y, step(p.z) + z};
    }
    static uint64_t key(const Cell& c)
    {
        const auto bits = [](int32_t v) { return static_cast<uint64_t>(v) & 0x1FFFFF; };
        return bits(c[0]) << 42 | bits(c[1]) << 21 | bits(c[2]);
    }

    float size_;
    std::unordered_map<uint64_t, std::vector<uint32_t>> cells_;
};

// In rising order: those at an edge that one triangle has alone.
std::vector<uint32_t> border_vertices(const Mesh& mesh)
{
    std::unordered_map<uint64_t, uint32_t> uses;
    for (const Mesh::Corners& c : mesh.corners)
        for (size_t i = 0; i < 3; ++i) ++uses[edge_key(c[i], c[(i + 1) % 3])];
    std::vector<uint32_t> vertices;
    for (const auto& [edge, count] : uses)
        if (count == 1)
            vertices.insert(vertices.end(), {static_cast<uint32_t>(edge >> 32), static_cast<uint32_t>(edge)});
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

// For each vertex the one that it becomes.
std::vector<uint32_t> joined_vertices(const Mesh& mesh, Components& parts, float reach)
{
    const std::vector<uint32_t> border = border_vertices(mesh);
    const auto is_of_lower_part = [&](uint32_t a, uint32_t b) { return parts.of(a) < parts.of(b); };
    std::vector<uint32_t> by_part = border;
    std::sort(by_part.begin(), by_part.end(), is_of_lower_part);
    Cells all(reach), first(reach);
    for (const uint32_t v : by_part) all.add(mesh.positions[v], v);
    std::vector<uint32_t> to(mesh.positions.size());
    std::iota(to.begin(), to.end(), 0u);
    for (const uint32_t v : border) {
        const Vec3& place = mesh.positions[v];
        const auto is_near = [&](uint32_t other) { return length(mesh.positions[other] - place) <= reach; };
        // A part's own vertices are passed over at once: a cell may hold all of a large one.
        const bool is_seam = all.any_around(place, [&](const std::vector<uint32_t>& list) {
            const auto [own, other] = std::equal_range(list.begin(), list.end(), v, is_of_lower_part);
            return std::any_of(list.begin(), own, is_near) || std::any_of(other, list.end(), is_near);
        });
        if (!is_seam) continue;
        const bool is_joined = first.any_around(place, [&](const std::vector<uint32_t>& list) {
            const auto found = std::find_if(list.begin(), list.end(), is_near);
            if (found != list.end()) to[v] = *found;
            return found != list.end();
        });
        if (!is_joined) first.add(place, v);
    }
    return to;
}

Mesh moved(const Mesh& mesh, const std::vector<uint32_t>& to)
{
    Mesh result;
    result.positions = mesh.positions;
    for (const Mesh::Corners& c : mesh.corners) result.corners.push_back({to[c[0]], to[c[1]], to[c[2]]});
    return result;
}

// Parts whose area would change more keep their vertices: strips that are narrower than the reach would vanish.
void keep_narrow_parts(const Mesh& mesh, Components& parts, std::vector<uint32_t>& to)
{
    constexpr double kMostChange = 0.15;
    const Mesh joined = moved(mesh, to);
    std::vector<double> before(to.size(), 0), after(to.size(), 0);
    for (size_t k = 0; k < mesh.triangle_count(); ++k) {
        const uint32_t part = parts.of(mesh.corners[k]);
        before[part] += static_cast<double>(mesh.area(k));
        after[part] += static_cast<double>(joined.area(k));
    }
    for (uint32_t v = 0; v < to.size(); ++v) {
        const uint32_t part = parts.of(v);
        if (std::abs(after[part] - before[part]) > kMostChange * before[part]) to[v] = v;
    }
}

}  // namespace

Mesh with_closed_seams(const Mesh& mesh, float reach)
{
    if (!(reach > kLeastReach)) return mesh;
    Components parts(mesh);
    std::vector<uint32_t> to = joined_vertices(mesh, parts, reach);
    keep_narrow_parts(mesh, parts, to);
    Mesh result = moved(mesh, to);
    size_t kept = 0;
    for (size_t k = 0; k < mesh.triangle_count(); ++k)
        if (!is_degenerate(result.corners[k]) || is_degenerate(mesh.corners[k]))
            result.corners[kept++] = result.corners[k];
    result.corners.resize(kept);
    return result;
}

}  // namespace lumi::baker
