// SPDX-License-Identifier: MIT
// The inner loops of the span renderer: one per reconstruction, over any texel, pixel and background.
//
// SpanDraw<Reconstruction>::draw(span) fills `length` pixels. Both sides' coordinates advance by addition; a texel's
// address is a sum of products of whole lattice steps; no division, no table, no clamping.
#pragma once

#include "lumi/reconstruction.h"
#include "lumi/span_lattice.h"
#include "lumi/span_sum.h"

namespace lumi
{

// A span to draw. Rows are addressed from `texels`; both sides hold strides in bytes.
template <class Background>
struct SpanTarget {
    const Field& field;
    const Background& background;
    uint8_t* pixels;
    int32_t length;
    int32_t x, y;  // of the first pixel
    SpanSide origins, directions;
};

// Where a side's lattice steps lie in memory.
struct SpanSteps {
    int32_t first, second, base;

    SpanSteps(const SpanSide& side, int32_t stride_bytes)
        : first(side.first * stride_bytes), second(side.second * stride_bytes), base(side.base * stride_bytes)
    {
    }

    int32_t at(int32_t u_q16, int32_t v_q16) const { return base + first * (u_q16 >> 16) + second * (v_q16 >> 16); }
};

template <class Texel, class Pixel, class Background>
void store_single(const Field& field, const Background& background, const uint8_t* texel, uint8_t* pixel)
{
    const Rgba8 c = Texel::load(field, texel, 0);
    if (c.a == 255) {
        Pixel::store(pixel, {c.r, c.g, c.b});
    } else if (c.a != 0 || Background::kFills) {
        const Rgb8 under = background.template under<Pixel>(pixel);
        const uint32_t t = 255u - c.a;
        const auto over = [&](uint8_t v, uint8_t u) {
            return static_cast<uint8_t>(v + (t * u * 257u + 32768u) / 65536u);
        };
        Pixel::store(pixel, {over(c.r, under.r), over(c.g, under.g), over(c.b, under.b)});
    }
}

// One tap: the point of the cell's coordinates, rounded down after `offset` was added.
template <class Texel, class Pixel, class Background, class Offset>
void draw_single(const SpanTarget<Background>& span, Offset offset)
{
    const SpanSteps rows(span.origins, static_cast<int32_t>(span.field.row_stride_bytes));
    const SpanSteps texels(span.directions, static_cast<int32_t>(format::bytes_per_texel(Texel::kFormat)));
    const uint8_t* base = span.field.texels + rows.base + texels.base;
    int32_t uo = span.origins.u_q16, vo = span.origins.v_q16;
    int32_t ud = span.directions.u_q16, vd = span.directions.v_q16;
    uint8_t* pixel = span.pixels;
    for (int32_t k = 0; k < span.length; ++k) {
        const int32_t add = offset(k);
        const uint8_t* texel = base + rows.first * ((uo + add) >> 16) + rows.second * ((vo + add) >> 16) +
                               texels.first * ((ud + add) >> 16) + texels.second * ((vd + add) >> 16);
        store_single<Texel, Pixel>(span.field, span.background, texel, pixel);
        uo += span.origins.du_q16;
        vo += span.origins.dv_q16;
        ud += span.directions.du_q16;
        vd += span.directions.dv_q16;
        pixel += Pixel::kBytes;
    }
}

// The corners of a cell's triangle as offsets in memory, with weights that sum to kSpanOne.
struct SpanTriangle {
    int32_t offset[3];
    uint32_t weight[3];

    SpanTriangle(const SpanSteps& steps, int32_t u_q16, int32_t v_q16)
    {
        const uint32_t fu = (static_cast<uint32_t>(u_q16) >> 8) & 255u;
        const uint32_t fv = (static_cast<uint32_t>(v_q16) >> 8) & 255u;
        const bool lower = fu > fv;
        const uint32_t more = lower ? fu : fv;
        const uint32_t less = lower ? fv : fu;
        offset[0] = steps.first * (u_q16 >> 16) + steps.second * (v_q16 >> 16);
        offset[1] = offset[0] + (lower ? steps.first : steps.second);
        offset[2] = offset[0] + steps.first + steps.second;
        weight[0] = kSpanOne - more;
        weight[1] = more - less;
        weight[2] = less;
    }
};

template <class Reconstruction>
struct SpanDraw;

template <>
struct SpanDraw<Nearest> {
    template <class Texel, class Pixel, class Background>
    static void draw(const SpanTarget<Background>& span)
    {
        constexpr int32_t kHalf = 1 << 15;
        draw_single<Texel, Pixel>(span, [](int32_t) { return kHalf; });
    }
};

template <>
struct SpanDraw<Linear> {
    template <class Texel, class Pixel, class Background>
    static void draw(const SpanTarget<Background>& span)
    {
        using Sum = SpanSum<Texel, !Background::kIsBlack>;
        const SpanSteps rows(span.origins, static_cast<int32_t>(span.field.row_stride_bytes));
        const SpanSteps texels(span.directions, static_cast<int32_t>(format::bytes_per_texel(Texel::kFormat)));
        const uint8_t* base = span.field.texels + rows.base + texels.base;
        int32_t uo = span.origins.u_q16, vo = span.origins.v_q16;
        int32_t ud = span.directions.u_q16, vd = span.directions.v_q16;
        uint8_t* pixel = span.pixels;
        for (int32_t k = 0; k < span.length; ++k) {
            const SpanTriangle origins(rows, uo, vo);
            const SpanTriangle directions(texels, ud, vd);
            Sum sum;
            for (int m = 0; m < 3; ++m) {
                const uint8_t* row = base + origins.offset[m];
                typename Sum::Row taps;
                for (int j = 0; j < 3; ++j) taps.add(span.field, row + directions.offset[j], directions.weight[j]);
                sum.add(taps, origins.weight[m]);
            }
            Pixel::store(pixel, sum.over(span.background.template under<Pixel>(pixel)));
            uo += span.origins.du_q16;
            vo += span.origins.dv_q16;
            ud += span.directions.du_q16;
            vd += span.directions.dv_q16;
            pixel += Pixel::kBytes;
        }
    }
};

}  // namespace lumi
