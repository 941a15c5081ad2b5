// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "math/warp.h"
#include "mesh/simplify/simplify.h"
#include "support/mesh_checks.h"

namespace lumi::baker::testing
{
namespace
{

void add_square(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
    mesh.corners.push_back({a, b, c});
    mesh.corners.push_back({a, c, d});
}

// A ring of points around the z axis.
uint32_t add_ring(Mesh& mesh, uint32_t sides, float radius, float z)
{
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (uint32_t s = 0; s < sides; ++s) {
        const float turn = 2 * kPi * static_cast<float>(s) / static_cast<float>(sides);
        mesh.positions.push_back({radius * std::cos(turn), radius * std::sin(turn), z});
    }
    return first;
}

// A stack of washers, each of whose faces has vertices of its own, as many as its machine chose: files of CAD programs
// are like that, and the faces' edges lie beside each other.
Mesh thin_discs(uint32_t discs, float thick, float gap)
{
    constexpr uint32_t kRim = 96, kFace = 120, kBore = 40;
    constexpr float kRadius = 0.6f, kBoreRadius = 0.2f;
    Mesh mesh;
    const auto add_wall = [&](uint32_t sides, float radius, float from, float to) {
        const uint32_t low = add_ring(mesh, sides, radius, from), high = add_ring(mesh, sides, radius, to);
        for (uint32_t s = 0; s < sides; ++s) {
            const uint32_t next = (s + 1) % sides;
            add_square(mesh, low + s, low + next, high + next, high + s);
        }
    };
    for (uint32_t k = 0; k < discs; ++k) {
        const float low = (thick + gap) * (static_cast<float>(k) - 0.5f * static_cast<float>(discs));
        add_wall(kRim, kRadius, low, low + thick);
        add_wall(kBore, kBoreRadius, low + thick, low);
        for (const bool is_top : {false, true}) {
            const float z = is_top ? low + thick : low;
            const uint32_t outer = add_ring(mesh, kFace, kRadius, z), inner = add_ring(mesh, kFace, kBoreRadius, z);
            for (uint32_t s = 0; s < kFace; ++s) {
                const uint32_t next = (s + 1) % kFace;
                is_top ? add_square(mesh, outer + s, outer + next, inner + next, inner + s)
                       : add_square(mesh, outer + next, outer + s, inner + s, inner + next);
            }
        }
    }
    return mesh;
}

// Level plates above each other, each face of `steps` times `steps` squares.
Mesh level_plates(uint32_t plates, uint32_t steps, float thick, float gap)
{
    Mesh mesh;
    for (uint32_t k = 0; k < plates; ++k) {
        const float low = (thick + gap) * (static_cast<float>(k) - 0.5f * static_cast<float>(plates));
        const auto bottom = static_cast<uint32_t>(mesh.positions.size()), row = steps + 1, top = bottom + row * row;
        for (const float z : {low, low + thick})
            for (uint32_t p = 0; p < row * row; ++p)
                mesh.positions.push_back({static_cast<float>(p % row) / static_cast<float>(steps) - 0.5f,
                                          static_cast<float>(p / row) / static_cast<float>(steps) - 0.5f, z});
        for (uint32_t p = 0; p < row * row; ++p) {
            if (p % row == steps || p / row == steps) continue;
            add_square(mesh, bottom + p, bottom + p + row, bottom + p + row + 1, bottom + p + 1);
            add_square(mesh, top + p, top + p + 1, top + p + row + 1, top + p + row);
        }
        for (uint32_t s = 0; s < steps; ++s) {
            const auto add_wall = [&](uint32_t a, uint32_t b) {
                add_square(mesh, bottom + a, bottom + b, top + b, top + a);
            };
            add_wall(s, s + 1);
            add_wall(row * steps + s + 1, row * steps + s);
            add_wall(row * (s + 1), row * s);
            add_wall(row * s + steps, row * (s + 1) + steps);
        }
    }
    return mesh;
}

// The share of the area that faces up or down, but not quite.
double tilted_share(const Mesh& mesh)
{
    double tilted = 0;
    for (size_t k = 0; k < mesh.triangle_count(); ++k) {
        const float up = std::abs(normalized(mesh.area_vector(k)).z);
        if (up > 0.5f && up < 0.99f) tilted += static_cast<double>(mesh.area(k));
    }
    return tilted / whole_area(mesh);
}

}  // namespace

TEST_CASE("A stack of thin discs keeps its planes with few triangles", "[mesh]")
{
    const Mesh fins = thin_discs(12, 0.03f, 0.04f);
    const Mesh few = simplified(fins, 1000);
    CHECK(few.triangle_count() <= 1000);
    CHECK(few.triangle_count() > 900);
    CHECK(tilted_share(few) < 0.1);
    CHECK(whole_area(few) > 0.9 * whole_area(fins));
}

TEST_CASE("Parallel plates keep their planes and creases with the fewest triangles", "[mesh]")
{
    constexpr uint32_t kPlates = 10, kOfBox = 12;
    const Mesh plates = level_plates(kPlates, 8, 0.02f, 0.05f);
    const Mesh few = simplified(plates, kPlates * kOfBox);
    CHECK(few.triangle_count() <= kPlates * kOfBox);
    CHECK(tilted_share(few) < 1e-3);
    CHECK(whole_area(few) == Approx(whole_area(plates)).epsilon(1e-3));
}

TEST_CASE("Of two surfaces alike, the one that is seen more keeps more triangles", "[mesh]")
{
    constexpr uint32_t kSteps = 40, kRow = kSteps + 1;
    Mesh mesh;
    std::vector<float> openness;
    for (const float from : {-1.0f, 0.1f}) {
        const auto first = static_cast<uint32_t>(mesh.positions.size());
        for (uint32_t p = 0; p < kRow * kRow; ++p) {
            const float x = static_cast<float>(p % kRow) / kSteps, y = static_cast<float>(p / kRow) / kSteps;
            mesh.positions.push_back({from + 0.9f * x, y, 0.05f * std::sin(9 * x) * std::cos(7 * y)});
            openness.push_back(from < 0 ? 0.8f : 0.05f);
            if (x < 1 && y < 1) add_square(mesh, first + p, first + p + 1, first + p + kRow + 1, first + p + kRow);
        }
    }
    const auto share_of_left = [](const Mesh& few) {
        size_t left = 0;
        for (size_t k = 0; k < few.triangle_count(); ++k) left += few.position(k, 0).x < 0 ? 1u : 0u;
        return static_cast<double>(left) / static_cast<double>(few.triangle_count());
    };
    CHECK(share_of_left(simplified(mesh, 300)) == Approx(0.5).margin(0.03));
    CHECK(share_of_left(simplified(mesh, 300, openness)) > 0.6);
}

TEST_CASE("A large body keeps its shape beside thousands of triangles that are too small to show", "[mesh]")
{
    Mesh mesh = level_plates(1, 1, 0.6f, 0.1f);
    const Mesh box = mesh;
    const Mesh beads = thin_discs(1, 0.02f, 0);
    for (uint32_t bead = 0; bead < 40; ++bead) {
        const auto first = static_cast<uint32_t>(mesh.positions.size());
        const Vec3 place = {0.1f * static_cast<float>(bead % 8) - 0.35f, 0.1f * static_cast<float>(bead / 8), 0.32f};
        for (const Vec3& p : beads.positions) mesh.positions.push_back(place + p * 0.02f);
        for (const Mesh::Corners& c : beads.corners) mesh.corners.push_back({first + c[0], first + c[1], first + c[2]});
    }
    const Mesh few = simplified(mesh, 200);
    CHECK(few.triangle_count() <= 200);
    for (const Vec3& corner : box.positions) {
        const auto is_corner = [&](const Vec3& p) { return length(p - corner) < 1e-6f; };
        CHECK(std::any_of(few.positions.begin(), few.positions.end(), is_corner));
    }
}

}  // namespace lumi::baker::testing
