// SPDX-License-Identifier: MIT
// The pieces that core draws triangles in, counted while they are made.
#pragma once

#include <cmath>

#include "planner/counted_rows.h"
#include "surface/fill.h"
#include "surface/lists.h"
#include "surface/order.h"

namespace lumi::planner
{

// How many samples core looks at to know whether a triangle is hidden (src/surface/fill.h); 0: its box has none.
inline uint32_t looked_at(const detail::Seen& s, const detail::Target& target)
{
    detail::TriangleSize size;
    detail::Extent columns;
    if (!detail::set_size(size, columns, s, target)) return 0;
    const int32_t most = detail::nearest_depth(s);
    uint32_t count = 0;
    for (int32_t y = size.first_row; y < size.end_row; ++y)
        for (int32_t x = columns.begin; x < columns.end; ++x) {
            ++count;
            if (target.depths(y - target.y)[x] < most) return count;
        }
    return count;
}

// Whether core looks at what a triangle's colour loses (src/surface/fill.cpp).
inline bool is_looked_at_for_colour(const detail::Seen& s, const detail::Target& target)
{
    detail::TriangleSize size;
    detail::Extent columns;
    return detail::set_size(size, columns, s, target) && detail::may_lose_colour(size.longer_q6, *s.a, *s.b, *s.c);
}

// Begins a triangle as a whole; false if none of it shows.
inline bool begins(detail::TrianglePiece& piece, const SurfaceFrame& frame, uint32_t triangle,
                   const detail::Target& target, SurfaceItem boxed, SurfaceItem looked, SurfaceItem begun)
{
    if (const uint32_t count = looked_at(detail::seen(frame, triangle), target); count != 0) {
        add(boxed);
        add(looked, count);
    }
    if (!detail::begin_whole(piece, frame, triangle, target)) return false;
    add(begun);
    if (is_looked_at_for_colour(detail::seen(frame, triangle), target)) add(SurfaceItem::wide_looked_at);
    return true;
}

// The parts of a large triangle. Each halving halves its area, so the parts that are drawn tell how much was dropped,
// and nearly how many steps that took.
class CountedParts
{
public:
    CountedParts(const SurfaceFrame& frame, const detail::Target& target) : frame_(frame), target_(target) {}

    void begin(uint32_t triangle)
    {
        add(SurfaceItem::large);
        detail::begin_parts(parts_, frame_, triangle);
        left_ = 1;
        ready_ = 0;
    }

    // False after the last.
    bool next(detail::TrianglePiece& piece)
    {
        if (parts_.count == 0) return false;
        detail::Corner corner[3];
        while (detail::next_part(parts_, frame_, target_, corner)) {
            ++ready_;
            left_ -= share_of(corner);
            detail::TriangleSize size;
            detail::Extent columns;
            if (detail::set_size(size, columns, {corner[0].at, corner[1].at, corner[2].at}, target_) &&
                detail::begin_triangle(piece, corner, size, parts_.texture, target_)) {
                add(SurfaceItem::parts);
                return true;
            }
        }
        add(SurfaceItem::halved, 2 * (ready_ + dropped()) - 1);
        return false;
    }

private:
    // The triangle's area as a power of two.
    double share_of(const detail::Corner (&c)[3]) const
    {
        const auto area = [](double au, double av, double bu, double bv) { return std::fabs(au * bv - bu * av); };
        const double whole = area(parts_.u_q8[1] - parts_.u_q8[0], parts_.v_q8[1] - parts_.v_q8[0],
                                  parts_.u_q8[2] - parts_.u_q8[0], parts_.v_q8[2] - parts_.v_q8[0]);
        const double part =
            area(c[1].u_q8 - c[0].u_q8, c[1].v_q8 - c[0].v_q8, c[2].u_q8 - c[0].u_q8, c[2].v_q8 - c[0].v_q8);
        return part > 0 ? std::exp2(std::round(std::log2(part / whole))) : 0;
    }

    // Parts that lie beside the target, at least: a binary fraction has as many powers of two.
    int dropped() const
    {
        int count = 0;
        constexpr int kDeepest = 20;
        double rest = std::max(left_, 0.0);
        for (int k = 0; k <= kDeepest; ++k)
            if (const double power = std::exp2(-k); rest >= power) {
                rest -= power;
                ++count;
            }
        return count;
    }

    const SurfaceFrame& frame_;
    const detail::Target& target_;
    detail::Parts parts_;
    double left_ = 0;
    int ready_ = 0;
};

// Whether a wide triangle has another part.
inline bool goes_on(detail::TrianglePiece& piece)
{
    if (piece.is_wide) add(SurfaceItem::wide);
    return piece.is_wide && detail::next_part_of_wide(piece);
}

// As detail::TrianglePieces, counted.
class CountedPieces
{
public:
    CountedPieces(const SurfaceFrame& frame, const detail::Target& target)
        : piece(target),
          frame_(frame),
          target_(target),
          walk_(detail::walk_of(frame, target)),
          other_(frame.memory.bands[frame.other_list]),
          parts_(frame, target)
    {
    }

    bool next()
    {
        if (goes_on(piece)) return true;
        for (uint32_t triangle = 0; detail::next_listed(walk_, frame_, triangle);) {
            add(SurfaceItem::visited);
            if (begins(piece, frame_, triangle, target_, SurfaceItem::boxed, SurfaceItem::looked_at,
                       SurfaceItem::begun))
                return true;
        }
        return next_part();
    }

    detail::TrianglePiece piece;

private:
    bool next_part()
    {
        while (true) {
            if (parts_.next(piece)) return true;
            if (other_ == detail::kEmptyBand) return false;
            parts_.begin(other_);
            other_ = detail::after(other_, frame_.memory.links[other_]);
        }
    }

    const SurfaceFrame& frame_;
    const detail::Target& target_;
    detail::ListWalk walk_;
    uint32_t other_;
    CountedParts parts_;
};

// As detail::SeeThroughPieces.
class CountedSeeThrough
{
public:
    CountedSeeThrough(const SeeThroughFrame& frame, const detail::Target& target)
        : piece(target), frame_(frame), target_(target), parts_(frame, target)
    {
        piece.rows.palette = frame.added_and_passed;
    }

    bool next()
    {
        if (goes_on(piece)) return true;
        while (true) {
            if (parts_.next(piece)) return true;
            if (at_ == frame_.order_count) return false;
            const uint32_t entry = frame_.order[at_++], triangle = detail::triangle_of(entry);
            add(SurfaceItem::see_visited);
            if ((entry & detail::kInParts) != 0)
                parts_.begin(triangle);
            else if (begins(piece, frame_, triangle, target_, SurfaceItem::see_boxed, SurfaceItem::see_looked_at,
                            SurfaceItem::see_begun))
                return true;
        }
    }

    detail::TrianglePiece piece;

private:
    const SeeThroughFrame& frame_;
    const detail::Target& target_;
    uint32_t at_ = 0;
    CountedParts parts_;
};

}  // namespace lumi::planner
