// SPDX-License-Identifier: MIT
#include "lumi/pack.h"

#include "lumi/pixel.h"

namespace lumi
{
namespace
{

constexpr uint32_t kSide = 8;

// Bayer's matrix: bits of x ^ y and y, taken in turns from the lowest up.
struct Thresholds {
    uint8_t of[kSide][kSide];  // 2 .. 253
};

constexpr Thresholds make_thresholds()
{
    Thresholds t{};
    for (uint32_t y = 0; y < kSide; ++y) {
        for (uint32_t x = 0; x < kSide; ++x) {
            uint32_t order = 0;
            for (uint32_t bit = 0; bit < 3; ++bit) order = order << 2 | ((x ^ y) >> bit & 1) << 1 | (y >> bit & 1);
            t.of[y][x] = static_cast<uint8_t>((2 * order + 1) * 255 / 128);
        }
    }
    return t;
}

constexpr Thresholds kThresholds = make_thresholds();

const uint8_t (&thresholds_of(int32_t y_px))[kSide]
{
    return kThresholds.of[static_cast<uint32_t>(y_px) % kSide];
}

const uint8_t* row_of(const Stripe& grey, int32_t row)
{
    return grey.pixels + static_cast<size_t>(row) * grey.stride_bytes;
}

// 0 .. kMost, between which the dither chooses.
template <uint32_t kMost>
uint32_t level(uint8_t value, uint8_t threshold)
{
    const uint32_t sum = kMost * value + threshold;
    return (sum + 1 + (sum >> 8)) >> 8;  // sum / 255
}

// Packs rows of pixels of kBits each, level_of(value, threshold).
template <uint32_t kBits, class LevelOf>
void pack_rows(const Stripe& grey, uint8_t* out, uint32_t out_stride_bytes, LevelOf level_of)
{
    for (int32_t row = 0; row < grey.height_px; ++row, out += out_stride_bytes) {
        const uint8_t* const pixels = row_of(grey, row);
        const uint8_t(&thresholds)[kSide] = thresholds_of(grey.y_px + row);
        uint32_t byte = 0, bits = 0, at = 0;
        for (int32_t x = 0; x < grey.width_px; ++x) {
            byte = byte << kBits | level_of(pixels[x], thresholds[static_cast<uint32_t>(grey.x_px + x) % kSide]);
            bits += kBits;
            if (bits == 8 || x + 1 == grey.width_px) {
                out[at++] = static_cast<uint8_t>(byte << (8 - bits));
                byte = bits = 0;
            }
        }
    }
}

uint32_t is_light(uint8_t value, uint8_t threshold)
{
    return value > threshold ? 1 : 0;
}

template <class Pixel>
void dither(const Stripe& rgb, uint8_t* out, uint32_t out_stride_bytes)
{
    for (int32_t row = 0; row < rgb.height_px; ++row, out += out_stride_bytes) {
        const uint8_t* from = row_of(rgb, row);
        const uint8_t(&thresholds)[kSide] = thresholds_of(rgb.y_px + row);
        for (int32_t x = 0; x < rgb.width_px; ++x, from += PixelRgb888::kBytes) {
            const uint8_t threshold = thresholds[static_cast<uint32_t>(rgb.x_px + x) % kSide];
            const uint32_t packed = level<31>(from[0], threshold) << 11 | level<63>(from[1], threshold) << 5 |
                                    level<31>(from[2], threshold);
            Pixel::store_packed(out + Pixel::kBytes * static_cast<uint32_t>(x), static_cast<uint16_t>(packed));
        }
    }
}

}  // namespace

void dither_rgb565(const Stripe& rgb, uint8_t* out, uint32_t out_stride_bytes)
{
    dither<PixelRgb565>(rgb, out, out_stride_bytes);
}

void dither_rgb565_swapped(const Stripe& rgb, uint8_t* out, uint32_t out_stride_bytes)
{
    dither<PixelRgb565Swapped>(rgb, out, out_stride_bytes);
}

void pack_grey4(const Stripe& grey, uint8_t* out, uint32_t out_stride_bytes)
{
    pack_rows<4>(grey, out, out_stride_bytes, level<15>);
}

void pack_mono1(const Stripe& grey, uint8_t* out, uint32_t out_stride_bytes)
{
    pack_rows<1>(grey, out, out_stride_bytes, is_light);
}

void pack_pages(const Stripe& grey, uint8_t* out, uint32_t out_stride_bytes)
{
    for (int32_t page = 0; page < grey.height_px / 8; ++page, out += out_stride_bytes) {
        for (int32_t x = 0; x < grey.width_px; ++x) {
            uint32_t byte = 0;
            for (int32_t k = 0; k < 8; ++k) {
                const int32_t row = 8 * page + k;
                const uint8_t threshold = thresholds_of(grey.y_px + row)[static_cast<uint32_t>(grey.x_px + x) % kSide];
                byte |= is_light(row_of(grey, row)[x], threshold) << k;
            }
            out[x] = static_cast<uint8_t>(byte);
        }
    }
}

}  // namespace lumi
