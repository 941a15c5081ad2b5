// SPDX-License-Identifier: MIT
#include "surface/fill.h"

#include "surface/planes.h"

namespace lumi::detail
{
namespace
{

// Where an edge crosses the scanlines, Q16 samples.
struct Walk {
    int32_t x_q16, step_q16;
};

// From the upper end's first scanline on, which is 0 to 63/64 below it. An edge less than a scanline high crosses one
// at most.
LUMI_ALWAYS_INLINE Walk walk_down(const SamplePoint& top, const SamplePoint& bottom, int32_t scanline)
{
    const int32_t first = line_from(top.y_q6), ahead_q6 = 64 * first + 32 - top.y_q6;
    const int32_t dx_q6 = bottom.x_q6 - top.x_q6, dy_q6 = bottom.y_q6 - top.y_q6;
    const Reciprocal r = reciprocal(static_cast<uint32_t>(dy_q6));
    const int32_t mantissa = static_cast<int32_t>(r.mantissa), shift = 31 - r.leading;
    if (dy_q6 < 64) {
        const int32_t share_q16 = (ahead_q6 * mantissa) >> shift;
        return {top.x_q6 * 1024 + ((dx_q6 * share_q16) >> 6), 0};
    }
    const int32_t step_q16 = (dx_q6 * mantissa) >> shift;
    return {top.x_q6 * 1024 + ((step_q16 * ahead_q6) >> 6) + step_q16 * (scanline - first), step_q16};
}

// The first sample at a crossing or to its right is the whole part of the crossing plus this.
constexpr int32_t kCentreBias = 0xFFFF - 0x8000;

enum class Filter : uint8_t { nearest, two_taps, bilinear };

// Between the middles of four texels of a rectangle, by 1/16 of a texel.
LUMI_ALWAYS_INLINE PackedColour bilinear_texel(uint32_t place, const Texture& texture, const PackedColour* palette)
{
    const int32_t u = static_cast<int32_t>(place & 0xFFFF) - 512, v = static_cast<int32_t>(place >> 16) - 512;
    const auto within = [](int32_t k, uint32_t count) {
        return k < 0 ? 0u : static_cast<uint32_t>(k) < count ? static_cast<uint32_t>(k) : count - 1;
    };
    const uint32_t left = within(u >> 10, texture.columns), right = within((u >> 10) + 1, texture.columns);
    const uint8_t* const upper = texture.texels + within(v >> 10, texture.rows) * texture.columns;
    const uint8_t* const lower = texture.texels + within((v >> 10) + 1, texture.rows) * texture.columns;
    const uint32_t to_right = static_cast<uint32_t>(u >> 6) & 15, down = static_cast<uint32_t>(v >> 6) & 15;
    uint32_t r = 0, g = 0, b = 0;
    const auto add = [&](uint8_t texel, uint32_t weight) {
        const PackedColour c = palette[texel];
        r += weight * (c >> 21);
        g += weight * ((c >> 10) & 0x3FF);
        b += weight * (c & 0x1FF);
    };
    add(upper[left], (16 - to_right) * (16 - down));
    add(upper[right], to_right * (16 - down));
    add(lower[left], (16 - to_right) * down);
    add(lower[right], to_right * down);
    return (r >> 8) << 21 | (g >> 8) << 10 | b >> 8;
}

// To the lower right; a little less than a quarter texel, so that no rounding leaves the rectangle.
constexpr uint32_t kQuarter = 200 << 16 | 200;

// Of two taps `place` is the upper left one's.
template <Filter kFilter>
LUMI_ALWAYS_INLINE PackedColour texel_at(uint32_t place, const Texture& texture, const PackedColour* palette)
{
    if constexpr (kFilter == Filter::nearest) {
        return palette[texture.texels[(place >> 26) * texture.columns + ((place << 16) >> 26)]];
    } else if constexpr (kFilter == Filter::two_taps) {
        return texel_at<Filter::nearest>(place, texture, palette) +
               texel_at<Filter::nearest>(place + 2 * kQuarter, texture, palette);
    } else {
        return bilinear_texel(place, texture, palette);
    }
}

// Draws the samples [depth_at, end) of a scanline, whose first quantities are given.
template <Filter kFilter>
LUMI_ALWAYS_INLINE void fill_samples(uint16_t* depth_at, const uint16_t* end, PackedColour* colour_at,
                                     uint32_t depth_q14, uint32_t place, PackedColour colour, const Planes& planes,
                                     const Texture texture, const PackedColour* palette, bool has_two_taps)
{
    do {
        const uint32_t depth = depth_q14 >> 14;
        if (depth > *depth_at) {
            *depth_at = static_cast<uint16_t>(depth);
            PackedColour texel = texel_at<kFilter>(place, texture, palette);
            if (kFilter == Filter::bilinear && has_two_taps) texel *= 2;
            PackedColour sum = colour + texel;
            if ((sum & kGuardBits) != 0) sum = clamped(sum);
            *colour_at = sum;
        }
        depth_q14 += planes.depth.right;
        place += planes.place.right;
        colour += planes.colour.right;
        ++colour_at;
    } while (++depth_at != end);
}

// A triangle's way down the target.
struct Descent {
    Planes planes;  // at column 0 of the scanline y
    Walk left, right;
    Walk lower;  // in place of one of them from the scanline `bend` on
    bool lower_is_left;
    int32_t y, bend, end;
};

template <Filter kFilter>
LUMI_ALWAYS_INLINE void fill_scanlines(const Descent& d, const Texture& texture, const Target& target)
{
    Planes at = d.planes;
    if (kFilter == Filter::two_taps) at.place.value -= kQuarter;
    Walk left = d.left, right = d.right;
    int32_t scanline = (d.y - target.y) * target.width;
    for (int32_t y = d.y; y < d.end; ++y) {
        if (y == d.bend) (d.lower_is_left ? left : right) = d.lower;
        const int32_t from = left.x_q16 >> 16, to = right.x_q16 >> 16;
        const int32_t first = from < 0 ? 0 : from, last = to > target.width ? target.width : to;
        if (first < last) {
            const uint32_t column = static_cast<uint32_t>(first);
            const auto at_first = [&](const Plane& p) { return p.value + column * p.right; };
            fill_samples<kFilter>(target.depths + scanline + first, target.depths + scanline + last,
                                  target.colours + scanline + first, at_first(at.depth), at_first(at.place),
                                  at_first(at.colour), at, texture, target.palette, target.has_two_taps);
        }
        left.x_q16 += left.step_q16;
        right.x_q16 += right.step_q16;
        scanline += target.width;
        at.depth.value += at.depth.down;
        at.place.value += at.place.down;
        at.colour.value += at.colour.down;
    }
}

LUMI_HOT __attribute__((noinline)) void fill_nearest(const Descent& d, const Texture& texture, const Target& target)
{
    fill_scanlines<Filter::nearest>(d, texture, target);
}

LUMI_HOT __attribute__((noinline)) void fill_two_taps(const Descent& d, const Texture& texture, const Target& target)
{
    fill_scanlines<Filter::two_taps>(d, texture, target);
}

LUMI_HOT __attribute__((noinline)) void fill_bilinear(const Descent& d, const Texture& texture, const Target& target)
{
    fill_scanlines<Filter::bilinear>(d, texture, target);
}

// A triangle's corners from the upper one on, and the scanlines of samples where it begins, its short edges meet and it
// ends.
struct Outline {
    const SamplePoint *top, *left, *right;
    int32_t first, bend, last;

    LUMI_ALWAYS_INLINE bool left_is_short() const { return left->y_q6 < right->y_q6; }
};

// Of corners that run counter-clockwise on the screen.
LUMI_ALWAYS_INLINE Outline outline_of(const SamplePoint* a, const SamplePoint* b, const SamplePoint* c)
{
    const bool b_is_top = b->y_q6 < a->y_q6 && b->y_q6 <= c->y_q6, c_is_top = !b_is_top && c->y_q6 < a->y_q6;
    const SamplePoint* top = b_is_top ? b : c_is_top ? c : a;
    const SamplePoint* left = b_is_top ? c : c_is_top ? a : b;
    const SamplePoint* right = b_is_top ? a : c_is_top ? b : c;
    const bool left_is_short = left->y_q6 < right->y_q6;
    return {top,
            left,
            right,
            line_from(top->y_q6),
            line_from(left_is_short ? left->y_q6 : right->y_q6),
            line_from(left_is_short ? right->y_q6 : left->y_q6)};
}

LUMI_ALWAYS_INLINE void set_edges(Descent& d, const Outline& o, int32_t first_column)
{
    const int32_t bias_q16 = kCentreBias - first_column * 65536;
    const auto walk = [&](const SamplePoint* top, const SamplePoint* bottom, int32_t y) {
        const Walk w = walk_down(*top, *bottom, y);
        return Walk{w.x_q16 + bias_q16, w.step_q16};
    };
    d.lower_is_left = o.left_is_short();
    d.bend = o.bend;
    if (o.bend < d.end) {
        const int32_t y = d.y < o.bend ? o.bend : d.y;
        d.lower = d.lower_is_left ? walk(o.left, o.right, y) : walk(o.right, o.left, y);
    }
    if (d.y >= o.bend) d.bend = d.y;
    if (d.y < o.bend || !d.lower_is_left) d.left = walk(o.top, o.left, d.y);
    if (d.y < o.bend || d.lower_is_left) d.right = walk(o.top, o.right, d.y);
}

}  // namespace

LUMI_HOT void fill_triangle(const Corner& a, const Corner& b, const Corner& c, bool two_sided, const Texture& texture,
                            const Target& target)
{
    Facing f = {&a, &b, &c, between(a.point, b.point), between(a.point, c.point)};
    int32_t area = doubled_area(f.ab, f.ac);
    if (area > 0 && two_sided) {
        f = {&a, &c, &b, f.ac, f.ab};
        area = -area;
    }
    if (area >= 0) return;
    const Outline o = outline_of(&f.a->point, &f.b->point, &f.c->point);
    const int32_t below = target.y + target.height;
    Descent d;
    d.y = o.first > target.y ? o.first : target.y;
    d.end = o.last < below ? o.last : below;
    if (d.y >= d.end) return;
    const Shares shares = shares_of(f, static_cast<uint32_t>(-area));
    const PlaneMaker maker(f, shares, target.x, d.y);
    d.planes = {maker.depth(), maker.place(), maker.colour()};
    set_edges(d, o, target.x);
    if (is_magnified(d.planes.place, target.magnified_q10))
        fill_bilinear(d, texture, target);
    else if (target.has_two_taps)
        fill_two_taps(d, texture, target);
    else
        fill_nearest(d, texture, target);
}

}  // namespace lumi::detail
