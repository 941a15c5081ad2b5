// SPDX-License-Identifier: MIT
// Depth, place in the texture and colour as affine functions of the sample.
#pragma once

#include "surface/fill.h"

namespace lumi::detail
{

// A quantity over a triangle, modulo 2^32: its value at column 0 of a scanline, and what it adds to the right and
// downwards.
struct Plane {
    uint32_t value, right, down;
};

struct Planes {
    Plane depth;   // Q14
    Plane place;   // v, u: 6 bits and 10 of fraction each
    Plane colour;  // PackedColour; steps are rounded to its last bit
};

// Whether neither coordinate of a texture changes by more than `most_q10` from sample to sample.
LUMI_ALWAYS_INLINE bool is_magnified(const Plane& place, int32_t most_q10)
{
    const auto fits = [&](uint32_t step) {
        const int32_t u = static_cast<int16_t>(step);
        const int32_t v = static_cast<int32_t>(step - static_cast<uint32_t>(u)) >> 16;
        return u <= most_q10 && u >= -most_q10 && v <= most_q10 && v >= -most_q10;
    };
    return fits(place.right) && fits(place.down);
}

struct Length {
    int32_t x_q6, y_q6;
};

LUMI_ALWAYS_INLINE Length between(const SamplePoint& from, const SamplePoint& to)
{
    return {to.x_q6 - from.x_q6, to.y_q6 - from.y_q6};
}

// Twice the area, Q12; negative where the corners run counter-clockwise on the screen. Of small triangles.
LUMI_ALWAYS_INLINE int32_t doubled_area(const Length& ab, const Length& ac)
{
    return ab.x_q6 * ac.y_q6 - ac.x_q6 * ab.y_q6;
}

// A triangle whose corners run counter-clockwise on the screen.
struct Facing {
    const Corner *a, *b, *c;
    Length ab, ac;
};

// What the shares of the corners b and c in a sample add to the right and downwards, Q16.
struct Shares {
    int32_t b_right, b_down, c_right, c_down;
};

// The shares in a triangle that is less than about a sample thick: it is taken for its longest edge, which becomes a-b.
Shares shares_of_sliver(Facing& f);

// 64·length/area, Q16, for an area of at least 64.
LUMI_ALWAYS_INLINE int32_t over_area(int32_t length_q6, const Reciprocal& r)
{
    return (length_q6 * static_cast<int32_t>(r.mantissa)) >> (25 - r.leading);
}

LUMI_ALWAYS_INLINE int32_t extent(const Length& e)
{
    const int32_t x = magnitude(e.x_q6), y = magnitude(e.y_q6);
    return x > y ? x : y;
}

LUMI_ALWAYS_INLINE Shares shares_of(Facing& f, uint32_t area)
{
    const int32_t of_b = extent(f.ab), of_c = extent(f.ac), longer = of_b > of_c ? of_b : of_c;
    if (area < static_cast<uint32_t>(longer) * 96) return shares_of_sliver(f);
    const Reciprocal r = reciprocal(area);
    return {-over_area(f.ac.y_q6, r), over_area(f.ac.x_q6, r), over_area(f.ab.y_q6, r), -over_area(f.ab.x_q6, r)};
}

// Planes from a sample near the triangle's middle, where roundings of steps add up least.
class PlaneMaker
{
public:
    LUMI_ALWAYS_INLINE PlaneMaker(const Facing& f, const Shares& shares, int32_t left, int32_t scanline)
        : a_(*f.a), b_(*f.b), c_(*f.c), shares_(shares)
    {
        const int32_t column = (a_.point.x_q6 + (f.ab.x_q6 + f.ac.x_q6) / 4) >> 6;
        const int32_t middle = (a_.point.y_q6 + (f.ab.y_q6 + f.ac.y_q6) / 4) >> 6;
        x_q6_ = column * 64 + 32 - a_.point.x_q6;
        y_q6_ = middle * 64 + 32 - a_.point.y_q6;
        columns_ = static_cast<uint32_t>(left - column);
        scanlines_ = static_cast<uint32_t>(scanline - middle);
    }

    LUMI_ALWAYS_INLINE Plane depth() const
    {
        const uint32_t to_b = b_.point.depth - a_.point.depth, to_c = c_.point.depth - a_.point.depth;
        const int32_t right = slope(to_b, to_c, &Shares::b_right, &Shares::c_right) >> 2;
        const int32_t down = slope(to_b, to_c, &Shares::b_down, &Shares::c_down) >> 2;
        const uint32_t middle = (a_.point.depth << 14) +
                                static_cast<uint32_t>(right >> 6) * static_cast<uint32_t>(x_q6_) +
                                static_cast<uint32_t>(down >> 6) * static_cast<uint32_t>(y_q6_);
        return plane(middle, static_cast<uint32_t>(right), static_cast<uint32_t>(down));
    }

    LUMI_ALWAYS_INLINE Plane place() const
    {
        const Coordinate u = coordinate(a_.u_q8, b_.u_q8, c_.u_q8), v = coordinate(a_.v_q8, b_.v_q8, c_.v_q8);
        return plane((v.middle << 16) + u.middle, (v.right << 16) + u.right, (v.down << 16) + u.down);
    }

    LUMI_ALWAYS_INLINE Plane colour() const
    {
        const Channel r = channel(red_q2), g = channel(green_q2), b = channel(blue_q2);
        return plane(packed_difference(r.middle, g.middle, b.middle), packed_difference(r.right, g.right, b.right),
                     packed_difference(r.down, g.down, b.down));
    }

private:
    struct Coordinate {
        uint32_t middle, right, down;  // Q10
    };
    struct Channel {
        int32_t middle, right, down;  // Q2
    };

    // Modulo 2^32.
    LUMI_ALWAYS_INLINE int32_t slope(uint32_t b_rise, uint32_t c_rise, int32_t Shares::*b, int32_t Shares::*c) const
    {
        return static_cast<int32_t>(static_cast<uint32_t>(shares_.*b) * b_rise +
                                    static_cast<uint32_t>(shares_.*c) * c_rise);
    }

    LUMI_ALWAYS_INLINE Plane plane(uint32_t middle, uint32_t right, uint32_t down) const
    {
        return {middle + columns_ * right + scanlines_ * down, right, down};
    }

    LUMI_ALWAYS_INLINE Coordinate coordinate(int32_t a, int32_t b, int32_t c) const
    {
        const uint32_t of_b = static_cast<uint32_t>(b - a), of_c = static_cast<uint32_t>(c - a);
        const int32_t right = slope(of_b, of_c, &Shares::b_right, &Shares::c_right) >> 14;
        const int32_t down = slope(of_b, of_c, &Shares::b_down, &Shares::c_down) >> 14;
        return {static_cast<uint32_t>(4 * a + ((right * x_q6_ + down * y_q6_) >> 6)), static_cast<uint32_t>(right),
                static_cast<uint32_t>(down)};
    }

    LUMI_ALWAYS_INLINE Channel channel(int32_t (*of)(uint32_t)) const
    {
        const int32_t from = of(a_.colour);
        const uint32_t of_b = static_cast<uint32_t>(of(b_.colour) - from),
                       of_c = static_cast<uint32_t>(of(c_.colour) - from);
        const int32_t right = slope(of_b, of_c, &Shares::b_right, &Shares::c_right);
        const int32_t down = slope(of_b, of_c, &Shares::b_down, &Shares::c_down);
        return {from + (((right >> 11) * x_q6_ + (down >> 11) * y_q6_) >> 11), (right + (1 << 15)) >> 16,
                (down + (1 << 15)) >> 16};
    }

    const Corner &a_, &b_, &c_;
    const Shares shares_;
    int32_t x_q6_, y_q6_;           // from the corner a to the sample
    uint32_t columns_, scanlines_;  // from the sample to column 0 of the first scanline
};

}  // namespace lumi::detail
