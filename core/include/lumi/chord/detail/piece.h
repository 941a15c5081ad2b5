// SPDX-License-Identifier: MIT
// The loops draw pieces: parts of a stripe, in a field, over a background.
#pragma once

#include "lumi/chord/detail/stepper.h"
#include "lumi/detail/compiler.h"

namespace lumi::detail
{

// The loops that draw pieces, one per reconstruction over any texel, pixel and background: draw(CellPiece) through
// cells, and draw_checked(CheckedPiece). Either fills all pixels of its piece, whose lines it may move. Through cells
// both sides' coordinates advance by addition and a texel's address is a sum of products of whole lattice steps; no
// division, no table, no clamping.
template <class Reconstruction>
struct SpanDraw {
    static_assert(sizeof(Reconstruction) == 0, "spans are drawn by Nearest and Linear; render() draws Paper<K>, too");
};

// A span through cells, or one below the other those of a tile's scanlines, so that what they share is set up once.
template <class Background>
struct CellPiece {
    const Field& field;
    const Background& background;
    uint8_t* pixels;
    int32_t length;
    CellLine& origins;  // in a tile of its own first scanline, until go_to_first()
    CellLine& directions;
    const TileScanlines* tile;  // null for one scanline

    LUMI_ALWAYS_INLINE void go_to_first()
    {
        if (tile != nullptr && tile->first > 0) move_down(tile->first);
    }
    // Goes on to the next scanline; false below the last of `count`, which it counts down.
    LUMI_ALWAYS_INLINE bool go_down(int32_t& count)
    {
        if (--count <= 0) return false;
        pixels += tile->stride_bytes;
        move_down(1);
        return true;
    }
    int32_t scanlines() const { return tile == nullptr ? 1 : tile->count; }

    LUMI_ALWAYS_INLINE void move_down(int32_t scanlines)
    {
        origins.move_down(tile->origins, scanlines);
        directions.move_down(tile->directions, scanlines);
    }
};

// A span whose every texel is asked for: over a pole, or with origins that are not baked.
template <class Background>
struct CheckedPiece {
    const Field& field;
    const Background& background;
    uint8_t* pixels;
    int32_t length;
    LatticeLine& origins;
    LatticeLine& directions;

    // An origin's texels; null where they are not baked.
    const uint8_t* row(int32_t origin) const { return field.row(static_cast<uint32_t>(origin)); }
    // Where a direction's texel lies in a row.
    template <class Texel>
    uint32_t offset(int32_t direction) const
    {
        const uint32_t j = static_cast<uint32_t>(direction);
        return j < field.directions.size() ? j * format::bytes_per_texel(Texel::kFormat) : 0;
    }
    // The texel at points of both lattices; null where it is not baked.
    template <class Texel>
    const uint8_t* texel(int32_t origin, int32_t direction) const
    {
        const uint8_t* const texels = row(origin);
        return texels != nullptr ? texels + offset<Texel>(direction) : nullptr;
    }
};

// Pieces that a stripe's sides cut: they are drawn into a scanline beside the stripe, of which the stripe gets its
// part. So a rectangle of any columns shows what the whole frame shows there, and loops know nothing of it.
inline constexpr int32_t kMostPiecePixels = 1 << kMaxSpanLog2;

inline bool is_cut(const Stripe& stripe, const Piece& piece)
{
    return piece.x < stripe.x_px || piece.x + piece.width > stripe.right_px();
}

// Copies what the stripe holds of a cut piece into `scanline`, where the piece begins.
void copy_from_stripe(const Stripe& stripe, const Piece& piece, uint32_t pixel_bytes, uint8_t* scanline);
// Copies it back, after it was drawn.
void copy_into_stripe(const Stripe& stripe, const Piece& piece, uint32_t pixel_bytes, const uint8_t* scanline);

}  // namespace lumi::detail
