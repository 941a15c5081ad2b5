// SPDX-License-Identifier: MIT
#include "geometry/smooth_groups.h"

#include <unordered_map>

#include "geometry/components.h"

namespace lumi::baker
{
namespace
{

// An edge of more triangles is no part of a surface. Each of its triangles is compared with all others.
constexpr size_t kMostSides = 64;

// An edge as one triangle has it: the corners at its lower and its higher vertex.
struct Side {
    uint32_t low, high;
    uint32_t triangle() const { return low / 3; }
};

using Sides = std::unordered_map<uint64_t, std::vector<Side>>;

Sides sides_of(const Mesh& mesh)
{
    Sides sides;
    for (uint32_t k = 0; k < mesh.triangle_count(); ++k) {
        for (uint32_t i = 0; i < 3; ++i) {
            const uint32_t j = (i + 1) % 3;
            const uint32_t a = mesh.corners[k][i], b = mesh.corners[k][j];
            const Side side = a < b ? Side{3 * k + i, 3 * k + j} : Side{3 * k + j, 3 * k + i};
            sides[edge_key(a, b)].push_back(side);
        }
    }
    return sides;
}

std::vector<Vec3> facings_of(const Mesh& mesh)
{
    std::vector<Vec3> result;
    for (size_t k = 0; k < mesh.triangle_count(); ++k) result.push_back(normalized(mesh.area_vector(k)));
    return result;
}

DisjointSets joined(const Mesh& mesh, const std::vector<Vec3>& facings, float crease_cosine)
{
    DisjointSets sets(3 * mesh.triangle_count());
    for (const auto& [edge, around] : sides_of(mesh)) {
        if (around.size() > kMostSides) continue;
        for (size_t a = 0; a < around.size(); ++a) {
            for (size_t b = 0; b < a; ++b) {
                if (dot(facings[around[a].triangle()], facings[around[b].triangle()]) >= crease_cosine) {
                    sets.join(around[a].low, around[b].low);
                    sets.join(around[a].high, around[b].high);
                }
            }
        }
    }
    return sets;
}

float angle_at(const Mesh& mesh, size_t triangle, size_t corner)
{
    const Vec3& p = mesh.position(triangle, corner);
    const Vec3 a = normalized(mesh.position(triangle, (corner + 1) % 3) - p);
    const Vec3 b = normalized(mesh.position(triangle, (corner + 2) % 3) - p);
    return std::acos(std::clamp(dot(a, b), -1.0f, 1.0f));
}

// Unit length; where triangles cancel out, a direction that one of them faces.
void add_normals(Mesh& mesh, const std::vector<Vec3>& facings)
{
    mesh.normals.assign(mesh.positions.size(), {});
    std::vector<Vec3> any(mesh.positions.size());
    for (size_t k = 0; k < mesh.triangle_count(); ++k) {
        for (size_t i = 0; i < 3; ++i) {
            Vec3& sum = mesh.normals[mesh.corners[k][i]];
            sum = sum + facings[k] * angle_at(mesh, k, i);
            any[mesh.corners[k][i]] = facings[k];
        }
    }
    for (size_t v = 0; v < mesh.normals.size(); ++v) {
        constexpr float kCancelled = 1e-3f;
        mesh.normals[v] = length(mesh.normals[v]) > kCancelled ? normalized(mesh.normals[v]) : any[v];
    }
}

}  // namespace

Mesh with_creases(const Mesh& mesh, float crease_cosine)
{
    const std::vector<Vec3> facings = facings_of(mesh);
    DisjointSets sets = joined(mesh, facings, crease_cosine);
    Mesh result;
    std::unordered_map<uint32_t, uint32_t> numbers;  // the vertex made for each set, by the set's root
    for (uint32_t k = 0; k < mesh.triangle_count(); ++k) {
        Mesh::Corners corners;
        for (uint32_t i = 0; i < 3; ++i) {
            const uint32_t next = static_cast<uint32_t>(result.positions.size());
            const auto [found, is_new] = numbers.emplace(sets.root(3 * k + i), next);
            if (is_new) result.positions.push_back(mesh.position(k, i));
            corners[i] = found->second;
        }
        result.corners.push_back(corners);
    }
    add_normals(result, facings);
    return result;
}

}  // namespace lumi::baker
