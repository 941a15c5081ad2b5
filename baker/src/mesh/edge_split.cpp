// SPDX-License-Identifier: MIT
#include "mesh/edge_split.h"

#include <map>
#include <queue>
#include <unordered_map>

namespace lumi::baker
{

namespace
{

constexpr float kMostMove = 0.1f;    // how far a new vertex may move onto the scene, as a share of its edge's length
constexpr float kMinFacing = 0.5f;   // cosine between the surface that it moves to and the triangles around
constexpr float kNextLayer = 1e-5f;  // from one hit to where the next one is looked for, in radii

// Where a ray meets a front face at no slant, as near as possible to the distance wanted; in radii along the ray.
std::optional<float> nearest_front(const MeshTracer& fronts, const Ray& ray, float wanted)
{
    std::optional<float> nearest;
    for (float passed = 0; passed < ray.end;) {
        const auto hit = fronts.closest({ray.origin + ray.direction * passed, ray.direction, ray.end - passed});
        if (!hit) break;
        const float at = passed + hit->distance;
        const Vec3 area = fronts.mesh().area_vector(hit->triangle);
        const bool is_alike = std::abs(dot(area, ray.direction)) > kMinFacing * length(area);
        if (is_alike && !(nearest && std::abs(*nearest - wanted) <= std::abs(at - wanted))) nearest = at;
        passed = at + kNextLayer;
    }
    return nearest;
}

class EdgeSplitter
{
public:
    EdgeSplitter(Mesh& mesh, float longest, const PlaceMiddle& place) : mesh_(mesh), longest_(longest), place_(place)
    {
        for (uint32_t k = 0; k < mesh.triangle_count(); ++k) {
            const Mesh::Corners& c = mesh.corners[k];
            for (size_t side = 0; side < 3; ++side) add(c[side], c[(side + 1) % 3], k);
        }
    }

    void run()
    {
        while (!queue_.empty()) {
            const Key key = queue_.top().second;
            queue_.pop();
            split(static_cast<uint32_t>(key >> 32), static_cast<uint32_t>(key));
        }
    }

private:
    using Key = uint64_t;  // of edges
    using Triangles = std::vector<uint32_t>;

    float edge_length(uint32_t a, uint32_t b) const { return length(mesh_.positions[a] - mesh_.positions[b]); }

    void add(uint32_t a, uint32_t b, uint32_t triangle)
    {
        const auto [edge, is_new] = triangles_.try_emplace(edge_key(a, b));
        edge->second.push_back(triangle);
        if (is_new && edge_length(a, b) > longest_) queue_.emplace(edge_length(a, b), edge->first);
    }

    void split(uint32_t a, uint32_t b)
    {
        const Triangles around = triangles_.at(edge_key(a, b));
        triangles_.erase(edge_key(a, b));
        const uint32_t middle = add_middle(a, b, around);
        for (const uint32_t k : around) split_triangle(k, a, b, middle);
    }

    uint32_t add_middle(uint32_t a, uint32_t b, const Triangles& around)
    {
        Vec3 middle = (mesh_.positions[a] + mesh_.positions[b]) * 0.5f;
        Vec3 facing;
        for (const uint32_t k : around) facing = facing + mesh_.area_vector(k);
        if (around.size() > 1 && length(facing) > 0) middle = place_(middle, normalized(facing), edge_length(a, b));
        mesh_.positions.push_back(middle);
        return static_cast<uint32_t>(mesh_.positions.size() - 1);
    }

    // The triangle keeps corner a; a new one gets corner b.
    void split_triangle(uint32_t triangle, uint32_t a, uint32_t b, uint32_t middle)
    {
        const uint32_t added = static_cast<uint32_t>(mesh_.triangle_count());
        Mesh::Corners kept = mesh_.corners[triangle], moved = kept;
        std::replace(kept.begin(), kept.end(), b, middle);
        std::replace(moved.begin(), moved.end(), a, middle);
        const uint32_t apex =
            *std::find_if(kept.begin(), kept.end(), [&](uint32_t v) { return v != a && v != middle; });
        mesh_.corners[triangle] = kept;
        mesh_.corners.push_back(moved);
        Triangles& beyond = triangles_.at(edge_key(b, apex));
        std::replace(beyond.begin(), beyond.end(), triangle, added);
        add(a, middle, triangle);
        add(middle, b, added);
        add(middle, apex, triangle);
        add(middle, apex, added);
    }

    Mesh& mesh_;
    float longest_;
    const PlaceMiddle& place_;
    std::unordered_map<Key, Triangles> triangles_;
    std::priority_queue<std::pair<float, Key>> queue_;  // edges that are too long
};

}  // namespace

PlaceMiddle onto(const MeshTracer& fronts)
{
    return [&](const Vec3& middle, const Vec3& facing, float edge) {
        const float reach = kMostMove * edge;
        const Ray ray = {middle + facing * reach, -facing, 2 * reach};
        const std::optional<float> at = nearest_front(fronts, ray, reach);
        return at ? ray.origin + ray.direction * *at : middle;
    };
}

Mesh with_short_edges(Mesh mesh, float longest, const PlaceMiddle& place)
{
    EdgeSplitter(mesh, longest, place).run();
    return mesh;
}

namespace
{

constexpr int32_t kOneQ14 = 1 << 14;

using Steps = std::array<int32_t, 3>;

int64_t square(int32_t v)
{
    return int64_t{v} * v;
}

Steps steps_of(const Vec3& p)
{
    const Vec3 scaled = p * (kOneQ14 / std::max(1.0f, length(p)));
    const auto nearest = [](float c) { return static_cast<int32_t>(std::lround(c)); };
    Steps s = {nearest(scaled.x), nearest(scaled.y), nearest(scaled.z)};
    if (square(s[0]) + square(s[1]) + square(s[2]) > square(kOneQ14)) {
        // Rounding towards the centre cannot leave the sphere.
        s = {static_cast<int32_t>(scaled.x), static_cast<int32_t>(scaled.y), static_cast<int32_t>(scaled.z)};
    }
    return s;
}

Vec3 position_of(const Steps& s)
{
    constexpr float kUnit = 1.0f / kOneQ14;
    return Vec3{static_cast<float>(s[0]), static_cast<float>(s[1]), static_cast<float>(s[2])} * kUnit;
}

// The area vector's components are exact in 64 bits.
bool has_area(const Steps& a, const Steps& b, const Steps& c)
{
    const auto minor = [&](size_t i, size_t j) {
        return int64_t{b[i] - a[i]} * (c[j] - a[j]) - int64_t{b[j] - a[j]} * (c[i] - a[i]);
    };
    return minor(0, 1) != 0 || minor(1, 2) != 0 || minor(2, 0) != 0;
}

}  // namespace

Mesh rounded(const Mesh& mesh)
{
    Mesh result;
    std::map<Steps, uint32_t> numbers;
    for (size_t k = 0; k < mesh.triangle_count(); ++k) {
        const std::array<Steps, 3> corners = {steps_of(mesh.position(k, 0)), steps_of(mesh.position(k, 1)),
                                              steps_of(mesh.position(k, 2))};
        if (!has_area(corners[0], corners[1], corners[2])) continue;
        Mesh::Corners numbered;
        for (size_t i = 0; i < 3; ++i) {
            const auto [found, is_new] = numbers.emplace(corners[i], static_cast<uint32_t>(result.positions.size()));
            if (is_new) result.positions.push_back(position_of(corners[i]));
            numbered[i] = found->second;
        }
        result.corners.push_back(numbered);
    }
    return result;
}

}  // namespace lumi::baker
