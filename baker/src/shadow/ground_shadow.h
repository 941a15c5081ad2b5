// SPDX-License-Identifier: MIT
// The shadow of an object on a level ground that touches its lowest point, where the scene has none.
//
// A field is drawn over any background, so the ground itself is not in it: only the share of its light that the object
// leaves. The shadow ends inside the sphere, where it fades out.
#pragma once

#include "image/tone.h"
#include "lumi/baker/surface.h"
#include "lumi/surface/format.h"
#include "mesh/patch_mesh.h"

namespace lumi::baker
{

// Square pieces, so many a side, are mapped onto the disc in which the ground cuts the sphere (square_to_disc()).
struct GroundShadow {
    float height = 0, radius = 0;    // of the disc, in the unit sphere's frame
    uint32_t pieces = 0, side = 0;   // pieces a side, and texels along the side of a piece
    std::vector<uint8_t> passed;     // by piece and texel, row after row: the share of the levels behind, 0 .. 255
    std::vector<std::string> notes;  // why there is none, a sentence

    bool is_there() const { return !passed.empty(); }
    // A corner of pieces, each 0 .. pieces.
    Vec3 corner(uint32_t x, uint32_t y) const;
    // Where the middle of a texel lies, each 0 .. pieces · side - 1: a piece is two triangles between its corners.
    Vec3 place(uint32_t x, uint32_t y) const;
    // Its number in `passed`.
    size_t texel(uint32_t x, uint32_t y) const;
};

template <class Io>
void fields(Io& io, GroundShadow& s)
{
    io(s.height, s.radius, s.pieces, s.side, s.passed, s.notes);
    constexpr uint32_t kMost = detail::format::kMaxPatchSide;
    io.require(s.pieces <= kMost && s.side <= kMost && s.radius >= 0 && s.radius <= 1 && s.height >= -1 &&
               s.height <= 1);
    io.require(s.passed.empty() || s.passed.size() == size_t{s.pieces} * s.pieces * s.side * s.side);
}

// One for a sphere's largest disc: its pieces a side, and texels along the side of a piece.
struct GroundGrid {
    uint32_t pieces, side;
};
GroundGrid ground_grid(float longest_edge, float texels_per_radius);

// None where the settings want none, or where the sphere has no room.
GroundShadow ground_shadow(const SceneData& scene, const PatchMesh& mesh, const SurfaceSettings& settings,
                           const ProgressCallback& progress);

}  // namespace lumi::baker
