// SPDX-License-Identifier: MIT
#include "geometry/open_edges.h"

#include <algorithm>
#include <limits>
#include <map>
#include <unordered_map>

#include "geometry/components.h"
#include "math/vec3.h"

namespace lumi::baker
{
namespace
{

struct PlaceHash {
    size_t operator()(const Vec3& p) const
    {
        size_t hash = 0;
        for (const float c : {p.x, p.y, p.z}) hash = hash * 0x9E3779B97F4A7C15 + std::hash<float>()(c);
        return hash;
    }
};
struct SamePlace {
    bool operator()(const Vec3& a, const Vec3& b) const { return a.x == b.x && a.y == b.y && a.z == b.z; }
};

struct Body {
    static constexpr float kFar = std::numeric_limits<float>::infinity();
    Vec3 low = {kFar, kFar, kFar}, high = {-kFar, -kFar, -kFar};
    double volume = 0, area = 0;

    float thickness() const
    {
        const Vec3 size = high - low;
        const float shortest = std::min({size.x, size.y, size.z}), longest = std::max({size.x, size.y, size.z});
        const float plate = area > 0 ? static_cast<float>(2 * std::abs(volume) / area) : 0.0f;
        constexpr float kFlat = 1e-4f;   // a share of the longest side
        constexpr float kPlate = 0.25f;  // a share of the shortest side; a cube and a ball have a third
        if (!(plate > kFlat * longest)) return 0;
        return plate < kPlate * shortest ? plate : shortest;
    }
};

}  // namespace

std::vector<Mesh::Corners> places_of(const Mesh& mesh)
{
    std::unordered_map<Vec3, uint32_t, PlaceHash, SamePlace> numbers;
    std::vector<uint32_t> place;
    for (const Vec3& p : mesh.positions)
        place.push_back(numbers.try_emplace(p, static_cast<uint32_t>(numbers.size())).first->second);
    std::vector<Mesh::Corners> result;
    for (const Mesh::Corners& c : mesh.corners) result.push_back({place[c[0]], place[c[1]], place[c[2]]});
    return result;
}

std::vector<size_t> open_edges(const Mesh& mesh, const std::vector<Mesh::Corners>& places, size_t materials)
{
    std::vector<std::pair<std::pair<uint32_t, uint32_t>, uint32_t>> sides;  // edges of triangles, with materials
    for (size_t t = 0; t < places.size(); ++t)
        for (size_t k = 0; k < 3; ++k)
            sides.emplace_back(std::minmax({places[t][k], places[t][(k + 1) % 3]}), mesh.materials[t]);
    std::sort(sides.begin(), sides.end());
    std::vector<size_t> open(materials, 0);
    for (size_t k = 0; k < sides.size(); ++k) {
        const bool as_before = k > 0 && sides[k - 1].first == sides[k].first;
        const bool as_after = k + 1 < sides.size() && sides[k + 1].first == sides[k].first;
        open[sides[k].second] += !as_before && !as_after ? 1u : 0u;
    }
    return open;
}

std::vector<float> flatnesses(const Mesh& mesh, const std::vector<Mesh::Corners>& places, size_t materials)
{
    DisjointSets sets(mesh.positions.size());
    for (size_t t = 0; t < places.size(); ++t) {
        sets.join(places[t][1], places[t][0]);
        sets.join(places[t][2], places[t][0]);
    }
    std::map<std::pair<uint32_t, uint32_t>, Vec3> sums;  // by material and root
    std::vector<float> areas(materials, 0), result(materials, 0);
    for (size_t t = 0; t < places.size(); ++t) {
        const Vec3 area = mesh.area_vector(t);
        Vec3& sum = sums[{mesh.materials[t], sets.root(places[t][0])}];
        sum = sum + area;
        areas[mesh.materials[t]] += length(area);
    }
    for (const auto& [part, sum] : sums)
        if (areas[part.first] > 0) result[part.first] += length(sum) / areas[part.first];
    return result;
}

std::vector<float> thicknesses(const Mesh& mesh, size_t materials)
{
    std::vector<Body> bodies(materials);
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        Body& body = bodies[mesh.materials[t]];
        for (size_t c = 0; c < 3; ++c) {
            const Vec3& p = mesh.position(t, c);
            body.low = {std::min(body.low.x, p.x), std::min(body.low.y, p.y), std::min(body.low.z, p.z)};
            body.high = {std::max(body.high.x, p.x), std::max(body.high.y, p.y), std::max(body.high.z, p.z)};
        }
    }
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        Body& body = bodies[mesh.materials[t]];
        const Vec3 middle = (body.low + body.high) * 0.5f;
        // A tetrahedron from the middle has a third of its height times its base, which is half of the cross product.
        const Vec3 area = mesh.area_vector(t);
        body.volume += static_cast<double>(dot(area, mesh.position(t, 0) - middle)) / 6;
        body.area += static_cast<double>(length(area)) / 2;
    }
    std::vector<float> result;
    for (const Body& body : bodies) result.push_back(body.thickness());
    return result;
}

}  // namespace lumi::baker
