// SPDX-License-Identifier: MIT
// Which spans core had to shorten: a longer one came too near a pole, left its zone's map or turned too far, which took
// as many instructions as a span that is drawn.
#pragma once

#include <algorithm>
#include <cstdint>

#include "lumi/chord/detail/stepper.h"

namespace lumi::planner
{

// Told of all pieces of a stripe, in their order.
class SpanTries
{
public:
    explicit SpanTries(int span_log2) : lengths_(1 << span_log2) {}

    void begin_scanline(const detail::Piece& scanline)
    {
        covered_[row_of(scanline)] = {scanline.x, scanline.x + scanline.width};
        tile_x_ = INT32_MIN;
    }
    void begin_tile(const detail::Piece& tile) { tile_x_ = tile.x; }

    // Counts of a span or a checked piece.
    bool is_shortened(const detail::Piece& span) const
    {
        const detail::Extent& covered = covered_[row_of(span)];
        const int32_t from_right = covered.end - 1 - span.x;
        if (from_right <= 0) return false;
        // Spans left of the last tile fill the gap before it.
        const int32_t end = span.x < tile_x_ ? std::min(tile_x_, covered.end) : covered.end;
        const int32_t length = std::min(span.width, from_right);  // the last pixel is the last span's end
        return length < lengths_.length(span.x - covered.begin, from_right, end - span.x);
    }

private:
    static size_t row_of(const detail::Piece& piece)
    {
        return static_cast<size_t>(piece.y & (detail::kTileHeight - 1));
    }

    detail::SpanLengths lengths_;
    detail::Extent covered_[detail::kTileHeight] = {};  // of the band's scanlines
    int32_t tile_x_ = INT32_MIN;                        // the band's last tile so far
};

}  // namespace lumi::planner
