// SPDX-License-Identifier: MIT
// Depth, place in the texture and colour as affine functions of the sample.
#pragma once

#include "surface/fill.h"

// Formats of planes: depth Q16; place v and u, 6 bits and 10 of fraction each; colour PackedColour, whose steps are
// rounded to its last bit.

namespace lumi::detail
{

// A quantity over a triangle, modulo 2^32: its value at column 0 of a scanline, and what it adds to the right and
// downwards.
struct Plane {
    uint32_t value, right, down;
};

// Tells whether neither coordinate of a texture changes by more than `most_q10` from sample to sample. A step is
// 2^16·dv + du modulo 2^32, so du is its lower half with its sign, and dv what is left above when du is taken away.
LUMI_ALWAYS_INLINE bool is_magnified(uint32_t right, uint32_t down, int32_t most_q10)
{
    const auto fits = [&](uint32_t step) {
        const int32_t u = static_cast<int16_t>(step);
        const int32_t v = static_cast<int32_t>(step - static_cast<uint32_t>(u)) >> 16;
        return u <= most_q10 && u >= -most_q10 && v <= most_q10 && v >= -most_q10;
    };
    return fits(right) && fits(down);
}

struct Length {
    int32_t x_q6, y_q6;
};

LUMI_ALWAYS_INLINE Length between(const SurfaceVertex& from, const SurfaceVertex& to)
{
    return {x_q6(to) - x_q6(from), y_q6(to) - y_q6(from)};
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

// A sample is a + s·(b - a) + t·(c - a). These are the changes of s and t from a sample to the next one to the right
// and to the one below, Q16: by Cramer's rule, s = cross(p - a, ac)/area and t = cross(ab, p - a)/area.
struct Shares {
    int32_t b_right, b_down, c_right, c_down;
};

// The shares in a triangle that is less than about a sample thick: it is taken for its longest edge, which becomes a-b.
Shares shares_of_sliver(Facing& f);

// Returns 64·length/area, Q16, for an area of at least 64.
LUMI_ALWAYS_INLINE int32_t over_area(int32_t length_q6, const Reciprocal& r)
{
    return (length_q6 * static_cast<int32_t>(r.mantissa)) >> (25 - r.leading);
}

// `longer_q6`: the longer side of the box around the triangle.
LUMI_ALWAYS_INLINE Shares shares_of(Facing& f, uint32_t area, int32_t longer_q6)
{
    if (area < static_cast<uint32_t>(longer_q6) * 96) return shares_of_sliver(f);
    const Reciprocal r = reciprocal(area);
    return {-over_area(f.ac.y_q6, r), over_area(f.ac.x_q6, r), over_area(f.ab.y_q6, r), -over_area(f.ab.x_q6, r)};
}

// Planes from a sample near the triangle's middle, where roundings of steps add up least.
class PlaneMaker
{
public:
    LUMI_ALWAYS_INLINE PlaneMaker(const Facing& f, const Shares& shares, int32_t left, int32_t row)
        : a_(*f.a), b_(*f.b), c_(*f.c), shares_(shares)
    {
        const int32_t ax_q6 = x_q6(*a_.at), ay_q6 = y_q6(*a_.at);
        const int32_t column = (ax_q6 + (f.ab.x_q6 + f.ac.x_q6) / 4) >> 6;
        const int32_t middle = (ay_q6 + (f.ab.y_q6 + f.ac.y_q6) / 4) >> 6;
        x_q6_ = column * 64 + 32 - ax_q6;
        y_q6_ = middle * 64 + 32 - ay_q6;
        columns_ = static_cast<uint32_t>(left - column);
        rows_ = static_cast<uint32_t>(row - middle);
    }

    LUMI_ALWAYS_INLINE Plane depth() const
    {
        const uint32_t from = depth_of(*a_.at), to_b = depth_of(*b_.at) - from, to_c = depth_of(*c_.at) - from;
        const int32_t right = slope(to_b, to_c, &Shares::b_right, &Shares::c_right);
        const int32_t down = slope(to_b, to_c, &Shares::b_down, &Shares::c_down);
        const uint32_t middle = (from << 16) + static_cast<uint32_t>(right >> 6) * static_cast<uint32_t>(x_q6_) +
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
        const uint32_t a = a_.at->colour, b = b_.at->colour, c = c_.at->colour;
        // Fields of PackedColour have two bits of fraction for green and red, and one for blue.
        const Channel red = channel(red_q2(a), red_q2(b), red_q2(c), 0);
        const Channel green = channel(green_q2(a), green_q2(b), green_q2(c), 0);
        const Channel blue = channel(blue_q2(a), blue_q2(b), blue_q2(c), 1);
        const auto fields = [&](int32_t Channel::*k) {
            return (static_cast<uint32_t>(green.*k) << 21) + (static_cast<uint32_t>(red.*k) << 10) +
                   static_cast<uint32_t>(blue.*k);
        };
        return plane(fields(&Channel::middle), fields(&Channel::right), fields(&Channel::down));
    }

    struct Lost {
        int32_t right, down;
    };

    // Sets what rounding the steps of colour() loses, and returns the most of it.
    LUMI_ALWAYS_INLINE Lost set_lost(WideTriangle& wide) const
    {
        const uint32_t a = a_.at->colour, b = b_.at->colour, c = c_.at->colour;
        Lost most = {0, 0};
        const auto lost = [](int32_t step, int drop, int32_t& most_lost) {
            const int32_t half = 1 << (15 + drop), rest = ((step + half) & (2 * half - 1)) - half;
            const int32_t size = rest < 0 ? -rest : rest;
            most_lost = size > most_lost ? size : most_lost;
            return rest;
        };
        const auto set = [&](int k, int32_t at_a, int32_t at_b, int32_t at_c, int drop) {
            const uint32_t of_b = static_cast<uint32_t>(at_b - at_a), of_c = static_cast<uint32_t>(at_c - at_a);
            wide.right[k] = lost(slope(of_b, of_c, &Shares::b_right, &Shares::c_right), drop, most.right);
            wide.down[k] = lost(slope(of_b, of_c, &Shares::b_down, &Shares::c_down), drop, most.down);
        };
        set(0, green_q2(a), green_q2(b), green_q2(c), 0);
        set(1, red_q2(a), red_q2(b), red_q2(c), 0);
        set(2, blue_q2(a), blue_q2(b), blue_q2(c), 1);
        wide.column = static_cast<int32_t>(0 - columns_);
        wide.row = static_cast<int32_t>(0 - rows_);
        return most;
    }

private:
    struct Coordinate {
        uint32_t middle, right, down;  // Q10
    };
    struct Channel {
        int32_t middle, right, down;
    };

    // Modulo 2^32.
    LUMI_ALWAYS_INLINE int32_t slope(uint32_t b_rise, uint32_t c_rise, int32_t Shares::*b, int32_t Shares::*c) const
    {
        return static_cast<int32_t>(static_cast<uint32_t>(shares_.*b) * b_rise +
                                    static_cast<uint32_t>(shares_.*c) * c_rise);
    }

    LUMI_ALWAYS_INLINE Plane plane(uint32_t middle, uint32_t right, uint32_t down) const
    {
        return {middle + columns_ * right + rows_ * down, right, down};
    }

    LUMI_ALWAYS_INLINE Coordinate coordinate(int32_t a, int32_t b, int32_t c) const
    {
        const uint32_t of_b = static_cast<uint32_t>(b - a), of_c = static_cast<uint32_t>(c - a);
        const int32_t right = slope(of_b, of_c, &Shares::b_right, &Shares::c_right) >> 14;
        const int32_t down = slope(of_b, of_c, &Shares::b_down, &Shares::c_down) >> 14;
        return {static_cast<uint32_t>(4 * a + ((right * x_q6_ + down * y_q6_) >> 6)), static_cast<uint32_t>(right),
                static_cast<uint32_t>(down)};
    }

    // Takes levels times 4; rounds to 2 bits of fraction less `drop`.
    LUMI_ALWAYS_INLINE Channel channel(int32_t a, int32_t b, int32_t c, int drop) const
    {
        const uint32_t of_b = static_cast<uint32_t>(b - a), of_c = static_cast<uint32_t>(c - a);
        const int32_t right = slope(of_b, of_c, &Shares::b_right, &Shares::c_right);
        const int32_t down = slope(of_b, of_c, &Shares::b_down, &Shares::c_down);
        const int32_t half = 1 << (15 + drop), to_sample = ((right >> 11) * x_q6_ + (down >> 11) * y_q6_) >> 11;
        return {(a + to_sample + drop) >> drop, (right + half) >> (16 + drop), (down + half) >> (16 + drop)};
    }

    const Corner &a_, &b_, &c_;
    const Shares shares_;
    int32_t x_q6_, y_q6_;      // from the corner a to the sample
    uint32_t columns_, rows_;  // from the sample to column 0 of the first row
};

}  // namespace lumi::detail
