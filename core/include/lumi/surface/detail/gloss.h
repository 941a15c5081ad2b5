// SPDX-License-Identifier: MIT
// A map (surface/format.h) holds what smooth surfaces mirror, for all directions of the world. Once a frame it is
// resampled into a disc of half vectors around the camera's axis: h lies between the mirrored direction and the axis,
// so that near the middle it is the normal, and the disc has no seam that faces the eye (after the "matcap" of
// modelling programs; the half vector is Blinn's, "Models of Light Reflection", 1977). Each vertex has its place in the
// disc for its normal and its own direction to the eye. Places are affine over a triangle.
//
// A disc is a square of 38 × 38 bytes. Its texel (x, y) has h = ((x - 18.5)/18, (18.5 - y)/18) along right and up; what
// lies beyond the circle is never shown. Between texels discs are bilinear: over a nearly flat surface one covers many
// pixels.
#pragma once

#include "lumi/surface/detail/pieces.h"

namespace lumi::detail
{

// The number of a patch's map from 1 on, or 0.
inline uint32_t gloss_of(const SurfaceField& field, uint32_t patch)
{
    const uint8_t* const choices = field.gloss + format::gloss_choices_at(gloss_count(field));
    return uint32_t{choices[patch >> 2]} >> (2 * (patch & 3)) & 3u;
}

// Where a frame's gloss lies in its memory: behind its parts; fields with gloss have no states.
struct GlossMemory {
    PackedColour* colours;  // kGlossColours a map
    uint8_t* discs;         // kGlossDiscBytes a map
    uint16_t* places;       // of vertices that have view tables: v and u, texels, Q2, 8 bits each

    explicit GlossMemory(const SurfaceFrame& frame)
        : colours(frame.memory.features + see_through_words(frame.field.see_through_count) +
                  part_words(frame.field.part_count)),
          discs(reinterpret_cast<uint8_t*>(colours + gloss_count(frame.field) * kGlossColours)),
          places(reinterpret_cast<uint16_t*>(discs + gloss_count(frame.field) * kGlossDiscBytes))
    {
    }
};

// The gloss of a triangle's rows: as Rows, `place` is given for the sample in column 0 and affine, 6 bits and 10 of
// fraction for v and u.
struct GlossRows {
    const uint8_t* disc = nullptr;  // null: none
    const PackedColour* colours = nullptr;
    uint32_t place = 0, right = 0, down = 0;
};

// Draw rows, and leave both at the one after them.
using DrawGlossRows = void (*)(Rows& rows, GlossRows& gloss);
LUMI_HOT void gloss_rows_565_nearest(Rows& rows, GlossRows& gloss);
LUMI_HOT void gloss_rows_565_two_taps(Rows& rows, GlossRows& gloss);
LUMI_HOT void gloss_rows_565_bilinear(Rows& rows, GlossRows& gloss);
LUMI_HOT void gloss_rows_565_swapped_nearest(Rows& rows, GlossRows& gloss);
LUMI_HOT void gloss_rows_565_swapped_two_taps(Rows& rows, GlossRows& gloss);
LUMI_HOT void gloss_rows_565_swapped_bilinear(Rows& rows, GlossRows& gloss);
LUMI_HOT void gloss_rows_packed_nearest(Rows& rows, GlossRows& gloss);
LUMI_HOT void gloss_rows_packed_two_taps(Rows& rows, GlossRows& gloss);
LUMI_HOT void gloss_rows_packed_bilinear(Rows& rows, GlossRows& gloss);

struct GlossFilters {
    DrawGlossRows nearest, two_taps, bilinear;
};

template <class Pixel>
inline constexpr GlossFilters kPixelGloss = {};
template <>
inline constexpr GlossFilters kPixelGloss<PixelRgb565> = {gloss_rows_565_nearest, gloss_rows_565_two_taps,
                                                          gloss_rows_565_bilinear};
template <>
inline constexpr GlossFilters kPixelGloss<PixelRgb565Swapped> = {
    gloss_rows_565_swapped_nearest, gloss_rows_565_swapped_two_taps, gloss_rows_565_swapped_bilinear};
inline constexpr GlossFilters kPackedGloss = {gloss_rows_packed_nearest, gloss_rows_packed_two_taps,
                                              gloss_rows_packed_bilinear};

// TrianglePieces that know the gloss of each.
class GlossPieces : public TrianglePieces
{
public:
    GlossPieces(const SurfaceFrame& frame, const Target& target) : TrianglePieces(frame, target), memory_(frame) {}

    LUMI_HOT bool next();

    GlossRows gloss;

protected:
    // The next one that is not cut, or false.
    bool next_whole();
    // The next one of those that are cut; `place` puts a triangle's corners where they are.
    template <class Place>
    bool next_cut_of(const Place& place);

private:
    bool next_cut();
    bool next_of_cut();
    // Sets the map of a patch; false: it has none.
    bool choose(uint32_t patch);
    // Begin the gloss of a whole triangle, of a piece of one that is cut, and of one whose corners lie there in the
    // disc.
    void begin_whole_gloss(uint32_t triangle);
    void begin_cut_gloss(const Corner (&corner)[3]);
    void begin_gloss(const Corner (&corner)[3]);
    // A corner at a place that memory holds, or whatever lies there.
    Corner in_disc(const SurfaceVertex* at, uint32_t place) const;

    const GlossMemory memory_;
    uint32_t first_place_ = 0;  // of the first part of a wide triangle
};

// Does that where parts may move. It is not LUMI_HOT: views whose parts rest would link it.
class MovingGlossPieces : public GlossPieces
{
public:
    using GlossPieces::GlossPieces;

    bool next();

private:
    bool next_cut();
};

template <DrawGlossRows kDrawRows>
struct GlossLoop {
    static constexpr DrawGlossRows kDraw = kDrawRows;
};

// Does what draw_triangles() does for opaque triangles, of which some have gloss. Pieces: GlossPieces or those that
// move.
template <class Pieces, DrawRows kPlain, DrawRows kMagnified, DrawGlossRows kGloss, DrawGlossRows kMagnifiedGloss>
__attribute__((noinline)) void draw_glossy_triangles(const SurfaceFrame& frame, const Target& target)
{
    Pieces pieces(frame, target);
    TrianglePiece& piece = pieces.piece;
    const auto draw = [&] {
        if (pieces.gloss.disc == nullptr)
            piece.is_magnified ? kMagnified(piece.rows) : kPlain(piece.rows);
        else
            piece.is_magnified ? kMagnifiedGloss(piece.rows, pieces.gloss) : kGloss(piece.rows, pieces.gloss);
    };
    while (pieces.next()) {
        if (!piece.is_cut) {
            draw();
            continue;
        }
        CutRows cut(piece.rows, target.width);
        do {
            cut.begin();
            draw();
        } while (cut.end());
    }
}

}  // namespace lumi::detail
