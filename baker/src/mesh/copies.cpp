// SPDX-License-Identifier: MIT
#include "mesh/copies.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace lumi::baker
{
namespace
{

constexpr float kFlat = 0.85f;  // cosine of the bend along a diagonal, 32°: more is a solid's edge

std::vector<uint32_t> copies_of_triangles(const Mesh& mesh)
{
    std::vector<Mesh::Corners> sets = mesh.corners;
    for (Mesh::Corners& set : sets) std::sort(set.begin(), set.end());
    std::vector<uint32_t> order(sets.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return sets[a] < sets[b]; });
    std::vector<uint32_t> first(sets.size());
    for (size_t k = 0; k < order.size(); ++k) {
        const bool is_copy = k != 0 && sets[order[k]] == sets[order[k - 1]];
        first[order[k]] = is_copy ? first[order[k - 1]] : order[k];
    }
    return first;
}

// A side of a triangle, and the vertex across from it.
struct Side {
    uint32_t low, high, across, triangle;
};

struct Quad {
    std::array<uint32_t, 4> corners;  // sorted
    std::array<uint32_t, 2> halves;   // triangles, the earlier one first
};

std::vector<Side> sides_of(const Mesh& mesh, const std::vector<uint32_t>& first)
{
    std::vector<Side> sides;
    for (uint32_t k = 0; k < first.size(); ++k) {
        if (first[k] != k) continue;
        for (size_t i = 0; i < 3; ++i) {
            const uint32_t a = mesh.corners[k][i], b = mesh.corners[k][(i + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), mesh.corners[k][(i + 2) % 3], k});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return sides;
}

bool is_flat(const Mesh& mesh, const Side& a, const Side& b)
{
    const Vec3 from = mesh.positions[a.low], along = mesh.positions[a.high] - from;
    const Vec3 left = cross(along, mesh.positions[a.across] - from),
               right = cross(along, mesh.positions[b.across] - from);
    return dot(left, right) < -kFlat * length(left) * length(right);
}

// Around a vertex of three triangles each two of them are a quad of the same corners: those are no copies.
bool share_a_triangle(const Quad& a, const Quad& b)
{
    return std::find_first_of(a.halves.begin(), a.halves.end(), b.halves.begin(), b.halves.end()) != a.halves.end();
}

// Two triangles with a side that no third one has.
std::vector<Quad> quads_of(const Mesh& mesh, const std::vector<uint32_t>& first)
{
    const std::vector<Side> sides = sides_of(mesh, first);
    const auto joins = [&](size_t a, size_t b) {
        return b < sides.size() && sides[a].low == sides[b].low && sides[a].high == sides[b].high;
    };
    std::vector<Quad> quads;
    for (size_t k = 0, next = 1; k < sides.size(); k = next++) {
        while (joins(k, next)) ++next;
        if (next - k != 2 || !is_flat(mesh, sides[k], sides[k + 1])) continue;
        Quad quad = {{sides[k].low, sides[k].high, sides[k].across, sides[k + 1].across},
                     {sides[k].triangle, sides[k + 1].triangle}};
        std::sort(quad.corners.begin(), quad.corners.end());
        quads.push_back(quad);
    }
    return quads;
}

}  // namespace

std::vector<uint32_t> first_copies(const Mesh& mesh)
{
    std::vector<uint32_t> first = copies_of_triangles(mesh);
    std::vector<Quad> quads = quads_of(mesh, first);
    std::sort(quads.begin(), quads.end(), [](const Quad& a, const Quad& b) {
        return std::tie(a.corners, a.halves) < std::tie(b.corners, b.halves);
    });
    std::vector<std::array<uint32_t, 2>> renamed;
    for (size_t k = 1, whole = 0; k < quads.size(); ++k) {
        if (quads[k].corners != quads[whole].corners)
            whole = k;
        else if (!share_a_triangle(quads[k], quads[whole]))
            for (size_t i = 0; i < 2; ++i) renamed.push_back({quads[k].halves[i], quads[whole].halves[i]});
    }
    std::vector<uint32_t> to = first;
    for (const auto& [half, of] : renamed) to[half] = of;
    for (uint32_t& f : first) f = to[f];
    return first;
}

}  // namespace lumi::baker
