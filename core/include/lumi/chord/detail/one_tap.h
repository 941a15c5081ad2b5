// SPDX-License-Identifier: MIT
// One texel a pixel: the loops of Nearest and Dither.
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

// One tap: the point of the cell's coordinates, rounded down after offset(pixel) was added on each side.
struct SpanOffsets {
    int32_t origins_q16, directions_q16;
};

// `Offsets`, of the scanline that begins at a pixel of the image, has at(pixel of the span) and kConstant: whether it
// is the same for all of them.
template <class Texel, class Pixel, class Offsets, class Background>
void draw_single(CellPiece<Background>& span)
{
    constexpr int32_t kBytes = static_cast<int32_t>(format::bytes_per_texel(Texel::kFormat));
    const int32_t stride = static_cast<int32_t>(span.field.row_stride_bytes);
    const CellIndex rows(span.origins, 1);
    const CellIndex texels(span.directions, kBytes);
    const uint8_t* const base = settled(span.field.texels + span.origins.base * stride + span.directions.base * kBytes);
    int32_t scanlines_left = span.scanlines();
    span.go_to_first();
    do {
        const Offsets offsets(span.x, span.y);
        int32_t uo = span.origins.u_q16, vo = span.origins.v_q16;
        int32_t ud = span.directions.u_q16, vd = span.directions.v_q16;
        const int32_t duo = settled(span.origins.du_q16), dvo = settled(span.origins.dv_q16);
        const int32_t dud = settled(span.directions.du_q16), dvd = settled(span.directions.dv_q16);
        if (Offsets::kConstant) {
            const SpanOffsets add = offsets.at(0);
            uo += add.origins_q16;
            vo += add.origins_q16;
            ud += add.directions_q16;
            vd += add.directions_q16;
        }
        uint8_t* pixel = span.pixels;
        const uint8_t* const end = pixel + static_cast<uint32_t>(span.length) * Pixel::kBytes;
        for (int32_t k = 0; pixel != end; ++k, pixel += Pixel::kBytes) {
            const SpanOffsets add = Offsets::kConstant ? SpanOffsets{0, 0} : offsets.at(k);
            const uint8_t* row = settled(base + rows.at(uo + add.origins_q16, vo + add.origins_q16) * stride);
            const uint8_t* texel = row + texels.at(ud + add.directions_q16, vd + add.directions_q16);
            store_single<Texel, Pixel>(span.field, span.background, texel, pixel);
            uo += duo;
            vo += dvo;
            ud += dud;
            vd += dvd;
        }
    } while (span.go_down(scanlines_left));
}

// The same where every texel is checked.
template <class Texel, class Pixel, class Offsets, class Background>
void draw_single_checked(const CheckedPiece<Background>& span)
{
    const Offsets offsets(span.x, span.y);
    SideWalk origins(span.origins);
    SideWalk directions(span.directions);
    uint8_t* pixel = span.pixels;
    for (int32_t k = 0; k < span.length; ++k, pixel += Pixel::kBytes) {
        const SpanOffsets add = offsets.at(k);
        store_checked<Texel, Pixel>(
            span,
            span.template texel<Texel>(origins.template one_tap<Offsets>(add.origins_q16),
                                       directions.template one_tap<Offsets>(add.directions_q16)),
            pixel);
        origins.advance();
        directions.advance();
    }
}

// To the nearest whole coordinates.
struct Rounding {
    static constexpr bool kConstant = true;
    Rounding(int32_t, int32_t) {}
    SpanOffsets at(int32_t) const { return {1 << 15, 1 << 15}; }

    static int pick(int32_t first_q16, int32_t second_q16, int32_t third_q16, int32_t)
    {
        const bool is_second = second_q16 > first_q16;
        const int32_t most_q16 = is_second ? second_q16 : first_q16;
        return third_q16 > most_q16 ? 2 : is_second ? 1 : 0;
    }
};

template <>
struct SpanDraw<Nearest> {
    template <class Texel, class Pixel, class Background>
    static void draw(CellPiece<Background>& span)
    {
        draw_single<Texel, Pixel, Rounding>(span);
    }
    template <class Texel, class Pixel, class Background>
    static void draw_checked(const CheckedPiece<Background>& span)
    {
        draw_single_checked<Texel, Pixel, Rounding>(span);
    }
};

// An ordered 4×4 dither (Bayer 1973) for the origins and the same one, turned, for the directions. Added to both
// coordinates of a side before they are rounded down, one threshold picks each corner of the cell's triangle as often
// as its barycentric weight says.
struct DitherMatrix {
    static constexpr uint8_t kRank[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

    static constexpr int32_t threshold_q16(int32_t x, int32_t y) { return (kRank[y & 3][x & 3] << 12) + (1 << 11); }
    static constexpr SpanOffsets at(int32_t x, int32_t y) { return {threshold_q16(x, y), threshold_q16(y + 1, ~x)}; }
};

// The thresholds of a span, a part of a scanline.
class DitherScanline
{
public:
    static constexpr bool kConstant = false;
    DitherScanline(int32_t x, int32_t y)
    {
        for (int32_t k = 0; k < 4; ++k) offsets_[k] = DitherMatrix::at(x + k, y);
    }
    const SpanOffsets& at(int32_t pixel) const { return offsets_[pixel & 3]; }

    static int pick(int32_t first_q16, int32_t second_q16, int32_t, int32_t threshold_q16)
    {
        const int32_t t = 65535 - threshold_q16;
        return t < first_q16 ? 0 : t < first_q16 + second_q16 ? 1 : 2;
    }

private:
    SpanOffsets offsets_[4];
};

template <>
struct SpanDraw<Dither> {
    template <class Texel, class Pixel, class Background>
    static void draw(CellPiece<Background>& span)
    {
        draw_single<Texel, Pixel, DitherScanline>(span);
    }
    template <class Texel, class Pixel, class Background>
    static void draw_checked(const CheckedPiece<Background>& span)
    {
        draw_single_checked<Texel, Pixel, DitherScanline>(span);
    }
};

}  // namespace lumi::detail
