// SPDX-License-Identifier: MIT
#include "lumi/pack.h"

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

// 0 .. 15, between which the dither chooses.
uint32_t level16(uint8_t value, uint8_t threshold)
{
    const uint32_t sum = 15u * value + threshold;
    return (sum + 1 + (sum >> 8)) >> 8;  // sum / 255
}

// Packs rows of pixels of kBits each, level(value, threshold).
template <uint32_t kBits, class Level>
void pack_rows(const Stripe& grey, uint8_t* out, uint32_t out_stride_bytes, Level level)
{
    for (int32_t row = 0; row < grey.height_px; ++row, out += out_stride_bytes) {
        const uint8_t* const pixels = row_of(grey, row);
        const uint8_t(&thresholds)[kSide] = thresholds_of(grey.y_px + row);
        uint32_t byte = 0, bits = 0, at = 0;
        for (int32_t x = 0; x < grey.width_px; ++x) {
            byte = byte << kBits | level(pixels[x], thresholds[static_cast<uint32_t>(grey.x_px + x) % kSide]);
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

}  // namespace

void pack_grey4(const Stripe& grey, uint8_t* out, uint32_t out_stride_bytes)
{
    pack_rows<4>(grey, out, out_stride_bytes, level16);
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
