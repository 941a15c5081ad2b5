// SPDX-License-Identifier: MIT
#include "mesh/simplify/steps.h"

#include <algorithm>
#include <unordered_map>

#include "geometry/components.h"

namespace lumi::baker
{
namespace
{

// Shares of a part's area. A convex part shows a quarter of its area in the mean of all views. A round rod has 0.83 of
// it with three sides, and 0.64 when it is flat.
constexpr double kTorn = 0.7, kEnough = 0.85;
constexpr double kLeastLoss = 1e-3;  // square radii of a part: less is 4 pixels at 240 x 240, in the mean of all views
constexpr size_t kMostShare = 4;     // all parts that are kept have so many times fewer triangles than the mesh
constexpr int kRounds = 4;           // what others need is taken from the rest, which may lose more then

double area_of(const std::vector<Vec3>& positions, const Mesh::Corners& c)
{
    const Vec3& a = positions[c[0]];
    return 0.5 * static_cast<double>(length(cross(positions[c[1]] - a, positions[c[2]] - a)));
}

double area_of(const std::vector<Vec3>& positions, const Triangles& triangles)
{
    double sum = 0;
    for (const Mesh::Corners& c : triangles) sum += area_of(positions, c);
    return sum;
}

struct Part {
    Triangles triangles;
    double area = 0;
    Triangles kept;  // those that stand for it, where it is kept
};

std::vector<Part> parts_of(const Mesh& mesh, std::vector<uint32_t>& part_of_vertex)
{
    Components components(mesh);
    std::unordered_map<uint32_t, uint32_t> numbers;
    std::vector<Part> parts;
    part_of_vertex.assign(mesh.positions.size(), 0);
    for (const Mesh::Corners& c : mesh.corners) {
        const auto [number, is_new] = numbers.try_emplace(components.of(c), static_cast<uint32_t>(parts.size()));
        if (is_new) parts.emplace_back();
        for (const uint32_t corner : c) part_of_vertex[corner] = number->second;
        parts[number->second].triangles.push_back(c);
        parts[number->second].area += area_of(mesh.positions, c);
    }
    return parts;
}

class ThinParts
{
public:
    // Borrows all.
    ThinParts(const Mesh& mesh, const Vertices& vertices, const MakeFewer& make_fewer)
        : mesh_(mesh), vertices_(vertices), make_fewer_(make_fewer), parts_(parts_of(mesh, part_of_vertex_))
    {
    }

    // The areas that are left of all parts, none counted for more than it had.
    double left(const Triangles& few) const
    {
        const std::vector<double> areas = areas_left(few);
        double sum = 0;
        for (size_t k = 0; k < parts_.size(); ++k) sum += std::min(areas[k], parts_[k].area);
        return sum;
    }

    // Keeps what `few` has torn, so that `most` triangles are kept in all. False where nothing is added.
    bool keep_torn(const Triangles& few, size_t most)
    {
        struct Candidate {
            uint32_t part;
            Triangles triangles;
            double saved;
        };
        const std::vector<double> areas = areas_left(few);
        std::vector<Candidate> candidates;
        for (uint32_t k = 0; k < parts_.size(); ++k) {
            const double lost = parts_[k].area - areas[k];
            if (!parts_[k].kept.empty() || areas[k] >= kTorn * parts_[k].area || lost < kLeastLoss) continue;
            candidates.push_back({k, fewest(parts_[k]), lost});
        }
        std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
            return a.saved * static_cast<double>(b.triangles.size()) >
                   b.saved * static_cast<double>(a.triangles.size());
        });
        bool any = false;
        for (Candidate& c : candidates) {
            if (kept_ + c.triangles.size() > most) continue;
            kept_ += c.triangles.size();
            parts_[c.part].kept = std::move(c.triangles);
            any = true;
        }
        return any;
    }

    size_t kept() const { return kept_; }

    // Only triangles that are not kept count.
    Triangles rest() const
    {
        Triangles rest;
        for (const Mesh::Corners& c : mesh_.corners)
            if (parts_[part_of_vertex_[c[0]]].kept.empty()) rest.push_back(c);
        return rest;
    }

    void add_kept(Triangles& to) const
    {
        for (const Part& part : parts_) to.insert(to.end(), part.kept.begin(), part.kept.end());
    }

private:
    std::vector<double> areas_left(const Triangles& few) const
    {
        std::vector<double> areas(parts_.size(), 0);
        for (const Mesh::Corners& c : few) areas[part_of_vertex_[c[0]]] += area_of(mesh_.positions, c);
        return areas;
    }

    // About as few triangles as keep the part's area.
    Triangles fewest(const Part& part) const
    {
        std::vector<uint32_t> vertices;
        for (const Mesh::Corners& c : part.triangles) vertices.insert(vertices.end(), c.begin(), c.end());
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        Vertices own;
        for (const uint32_t v : vertices) {
            own.positions.push_back(mesh_.positions[v]);
            if (!vertices_.openness.empty()) own.openness.push_back(vertices_.openness[v]);
        }
        Triangles best = part.triangles;
        for (Mesh::Corners& c : best)
            for (uint32_t& v : c)
                v = static_cast<uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
        const Triangles whole = best;
        for (size_t wanted = whole.size() / 2; wanted > 0; wanted /= 2) {
            Triangles fewer = make_fewer_(own, whole, wanted);
            if (area_of(own.positions, fewer) < kEnough * part.area) break;
            if (fewer.size() < best.size()) best = std::move(fewer);
        }
        for (Mesh::Corners& c : best)
            for (uint32_t& v : c) v = vertices[v];
        return best;
    }

    const Mesh& mesh_;
    const Vertices& vertices_;
    const MakeFewer& make_fewer_;
    std::vector<uint32_t> part_of_vertex_;
    std::vector<Part> parts_;
    size_t kept_ = 0;  // triangles
};

}  // namespace

Triangles fewer_with_thin_parts(const Mesh& mesh, const std::vector<float>& openness, size_t triangles,
                                const MakeFewer& make_fewer)
{
    const Vertices vertices = {mesh.positions, openness};
    Triangles best = make_fewer(vertices, mesh.corners, triangles);
    ThinParts parts(mesh, vertices, make_fewer);
    for (int k = 0; k < kRounds && parts.keep_torn(best, triangles / kMostShare); ++k) {
        Triangles fewer = make_fewer(vertices, parts.rest(), triangles - parts.kept());
        parts.add_kept(fewer);
        if (parts.left(fewer) <= parts.left(best)) break;
        best = std::move(fewer);
    }
    return best;
}

}  // namespace lumi::baker
