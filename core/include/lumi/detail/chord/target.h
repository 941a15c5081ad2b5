// SPDX-License-Identifier: MIT
// What the span renderer's inner loops draw.
#pragma once

#include "lumi/detail/register_hints.h"
#include "lumi/field.h"
#include "lumi/detail/stepping/zones.h"

namespace lumi
{

// Rows of a tile, of which a stripe may hold some only.
struct TileRows {
    int32_t first, count;  // the first one to draw
    uint32_t stride_bytes;
    const SpanDown& origins;
    const SpanDown& directions;
};

// A span, or one below the other those of a tile's rows. Through cells all rows are drawn at once, so that what they
// share is set up once; a row over a cap is drawn by itself.
template <class Background>
struct SpanTarget {
    const Field& field;
    const Background& background;
    uint8_t* pixels;
    int32_t length;
    int32_t x, y;       // of the first pixel
    SpanSide& origins;  // in a tile of its own first row, until go_to_first()
    SpanSide& directions;
    const TileRows* tile;  // null for one row

    bool is_over_cap() const { return origins.cap != nullptr || directions.cap != nullptr; }

    LUMI_ALWAYS_INLINE void go_to_first()
    {
        if (tile != nullptr && tile->first > 0) move_down(tile->first);
    }
    // Goes on to the next row; false below the last of `count` rows, which it counts down.
    LUMI_ALWAYS_INLINE bool go_down(int32_t& count)
    {
        if (--count <= 0) return false;
        pixels += tile->stride_bytes;
        ++y;
        move_down(1);
        return true;
    }
    int32_t rows() const { return tile == nullptr ? 1 : tile->count; }

    LUMI_ALWAYS_INLINE void move_down(int32_t rows)
    {
        origins.move_down(tile->origins, rows);
        directions.move_down(tile->directions, rows);
    }
};

}  // namespace lumi
