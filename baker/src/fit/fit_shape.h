// SPDX-License-Identifier: MIT
// The mesh of a surface field as its file holds it: what tracing, fitting and writing have in common.
#pragma once

#include "fit/gloss.h"
#include "lumi/surface/detail/view_nodes.h"
#include "mesh/patch_mesh.h"

namespace lumi::baker
{

// Where the texels of each patch lie (lumi/surface/format.h).

// n × m texels from `begin` on, row after row.
struct PatchRectangle {
    uint32_t begin, n, m;

    uint32_t size() const { return n * m; }
};

struct TexelLayout {
    std::vector<PatchRectangle> rectangles;  // by patch
    uint32_t texels = 0;                     // length of the section, unused ones at its end included
};

// Sides follow the lengths of a patch's edges, times texels a radius, by patch; of any size.
TexelLayout unlimited_layout(const PatchMesh& mesh, const std::vector<float>& densities);
// Throws BakeError where the format cannot hold so many texels.
TexelLayout layout_of(const PatchMesh& mesh, const std::vector<float>& densities);
// Every patch has the same density.
TexelLayout layout_of(const PatchMesh& mesh, float texels_per_radius);

// The texel at a point of a patch's first or second triangle, by the barycentric weights of its second and third
// corner.
uint32_t texel_at(const PatchRectangle& rectangle, bool second_triangle, float weight_of_second, float weight_of_third);
// The inverse: a place within a texel, which counts from the rectangle's first, by the weights of the first triangle's
// second and third corner. Their sum is above 1 on the second triangle, whose own weights are what both lack to 1.
Vec2 place_in(const PatchRectangle& rectangle, uint32_t texel, const Vec2& within);

// Half a turn about h = (x, y, z)/127 takes +z to the vertex's direction.
struct ViewTurn {
    int8_t x, y, z;
};

ViewTurn view_turn(const Vec3& normal);

// Points and eyes of the fit, Q12.
inline constexpr float kEyeScale = 4096;
struct EyePoint {
    int16_t x, y, z;
};

struct SeeThroughTexel {
    float coverage = 0;  // the share of lines that end there
    Rgb through;         // the share of light that passes
    float open = 1;      // of the lines that pass, the share that meets nothing behind
    Rgb behind;          // mean radiance that the others meet
};

template <class Io>
void fields(Io& io, SeeThroughTexel& texel)
{
    io(texel.coverage, texel.through, texel.open, texel.behind);
}

struct FitShape {
    // Densities are texels a radius, by patch.
    FitShape(PatchMesh mesh, const std::vector<float>& densities, std::vector<SeeThroughTexel> see_through = {},
             Gloss gloss = {});

    // Where an eye lies between the nodes of a vertex's view table.
    detail::ViewTaps taps(uint32_t vertex, const EyePoint& eye) const;
    // Corner 0, 1 or 2 of triangle 2p or 2p + 1, as a corner of its patch: 0 .. 3.
    static uint32_t patch_corner(uint32_t triangle, uint32_t corner) { return triangle % 2 == 0 ? corner : 3 - corner; }
    const Vec3& position(uint32_t triangle, uint32_t corner) const
    {
        return mesh.positions[vertex(triangle / 2, patch_corner(triangle, corner))];
    }
    // kNone for the fourth corner of a lone triangle.
    uint32_t vertex(uint32_t patch, uint32_t corner) const
    {
        const PatchMesh::Patch& p = mesh.patches[patch];
        return corner == 0 ? p.a : corner == 1 ? p.b : corner == 2 ? p.c : p.d;
    }

    // Returns the levels that a patch's map adds at a point of a triangle, for an eye. `weights` are barycentric.
    std::array<float, 3> mirrored(uint32_t triangle, const Vec2& weights, const EyePoint& eye) const;

    PatchMesh mesh;
    TexelLayout layout;
    std::vector<EyePoint> points;              // by vertex
    std::vector<ViewTurn> turns;               // by vertex
    std::vector<SeeThroughTexel> see_through;  // by texel, where the mesh has see-through patches
    Gloss gloss;
    std::vector<uint8_t> has_gloss;  // by vertex: some patch of it has a map, so it needs a view table; empty without
};

}  // namespace lumi::baker
