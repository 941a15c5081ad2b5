// SPDX-License-Identifier: MIT
// The loops of Nearest read one texel a pixel.
#pragma once

#include "lumi/chord/detail/piece.h"
#include "lumi/chord/detail/side_taps.h"
#include "lumi/chord/detail/sums.h"
#include "lumi/chord/reconstruction.h"
#include "lumi/pixel.h"

namespace lumi::detail
{

// A texel whose bits are the pixel's is copied.
template <class Texel, class Pixel>
inline constexpr bool kSameBits = false;
template <>
inline constexpr bool kSameBits<TexelRgb565, PixelRgb565> = true;

template <class Texel, class Pixel, class Background>
LUMI_ALWAYS_INLINE void store_single(const Field& field, const Background& background, const uint8_t* texel,
                                     uint8_t* pixel)
{
    if constexpr (kSameBits<Texel, Pixel>) {
        const uint16_t v = load_aligned<uint16_t>(texel);
        if (v != 0 || Background::kIsBlack) return store_aligned<uint16_t>(pixel, v);
        if (Background::kFills) Pixel::store(pixel, background.template under<Pixel>(pixel));
        return;
    }
    const Rgba8 c = Texel::load(field, texel, 0);
    if (c.a == 255)
        Pixel::store(pixel, {c.r, c.g, c.b});
    else if (c.a != 0 || Background::kFills)
        Pixel::store(pixel, over(c, background.template under<Pixel>(pixel)));
}

// A texel that is null is transparent.
template <class Texel, class Pixel, class Background>
void store_checked(const CheckedPiece<Background>& span, const uint8_t* texel, uint8_t* pixel)
{
    if (texel != nullptr) return store_single<Texel, Pixel>(span.field, span.background, texel, pixel);
    if (Background::kFills) Pixel::store(pixel, span.background.template under<Pixel>(pixel));
}

// Where the whole parts of two coordinates lie: their products with a side's steps, counted in `unit` bytes or points.
// Steps are below 378 (F_14) and a texel has at most three bytes, so with Armv7E-M's DSP extension both steps share a
// register and each product takes one instruction (SMULTB, SMLATT); the sums are the same.
class CellIndex
{
public:
#ifdef __ARM_FEATURE_DSP
    CellIndex(const CellLine& side, int32_t unit)
        : steps_((side.first * unit & 0xFFFF) | static_cast<int32_t>(static_cast<uint32_t>(side.second * unit) << 16))
    {
    }

    LUMI_ALWAYS_INLINE int32_t at(int32_t u_q16, int32_t v_q16) const
    {
        return __smlatt(v_q16, steps_, __smlatb(u_q16, steps_, 0));
    }

private:
    int32_t steps_;
#else
    CellIndex(const CellLine& side, int32_t unit) : first_(side.first * unit), second_(side.second * unit) {}

    LUMI_ALWAYS_INLINE int32_t at(int32_t u_q16, int32_t v_q16) const
    {
        return first_ * (u_q16 >> 16) + second_ * (v_q16 >> 16);
    }

private:
    int32_t first_, second_;
#endif
};

template <>
struct SpanDraw<Nearest> {
    template <class Texel, class Pixel, class Background>
    static void draw(CellPiece<Background>& span)
    {
        LUMI_TALLY(Work::piece, 1);
        constexpr int32_t kBytes = static_cast<int32_t>(format::bytes_per_texel(Texel::kFormat));
        const int32_t stride = static_cast<int32_t>(span.field.row_stride_bytes);
        const CellIndex rows(span.origins, 1);
        const CellIndex texels(span.directions, kBytes);
        const uint8_t* const base =
            settled(span.field.texels + span.origins.base * stride + span.directions.base * kBytes);
        int32_t scanlines_left = span.scanlines();
        span.go_to_first();
        do {
            LUMI_TALLY(nth_work(Work::pixel, static_cast<uint32_t>(Texel::kFormat)), span.length);
            int32_t uo = span.origins.u_q16 + kHalfCellQ16, vo = span.origins.v_q16 + kHalfCellQ16;
            int32_t ud = span.directions.u_q16 + kHalfCellQ16, vd = span.directions.v_q16 + kHalfCellQ16;
            const int32_t duo = settled(span.origins.du_q16), dvo = settled(span.origins.dv_q16);
            const int32_t dud = settled(span.directions.du_q16), dvd = settled(span.directions.dv_q16);
            uint8_t* pixel = span.pixels;
            const uint8_t* const end = pixel + static_cast<uint32_t>(span.length) * Pixel::kBytes;
            for (; pixel != end; pixel += Pixel::kBytes) {
                const uint8_t* row = settled(base + rows.at(uo, vo) * stride);
                store_single<Texel, Pixel>(span.field, span.background, row + texels.at(ud, vd), pixel);
                uo += duo;
                vo += dvo;
                ud += dud;
                vd += dvd;
            }
        } while (span.go_down(scanlines_left));
    }

    template <class Texel, class Pixel, class Background>
    static void draw_checked(const CheckedPiece<Background>& span)
    {
        LUMI_TALLY(Work::checked_pixel, span.length);
        SideWalk origins(span.origins);
        SideWalk directions(span.directions);
        uint8_t* pixel = span.pixels;
        for (int32_t k = 0; k < span.length; ++k, pixel += Pixel::kBytes) {
            store_checked<Texel, Pixel>(span, span.template texel<Texel>(origins.nearest(), directions.nearest()),
                                        pixel);
            origins.advance();
            directions.advance();
        }
    }
};

}  // namespace lumi::detail
