// SPDX-License-Identifier: MIT
// Reconstructions: which lattice points a hit reads, and with what weight.
//
// A reconstruction policy has `kTaps`, the number of taps a side, and `taps(lattice, direction)`. A pixel's colour is
// the sum over both sides' taps of w(i)·w(j)·L(i,j): the product kernel of LumiPath, section 2.3.
#pragma once
#pragma GCC system_header

#include "lumi/chord/texel.h"
#include "lumi/detail/lattice.h"

namespace lumi::detail
{

// `count` of them are used, 1 at least; their weights sum to kWeightOneQ12.
template <uint32_t Most>
struct Taps {
    uint32_t count;
    uint32_t index[Most];
    uint32_t weight_q12[Most];
};

}  // namespace lumi::detail

namespace lumi
{

// Takes the nearest lattice point of each side: one texel a pixel. On spans lattice coordinates are rounded, the
// cheapest cell.
struct Nearest {
    static constexpr uint32_t kTaps = 1;
    static detail::Taps<kTaps> taps(const detail::Lattice& lattice, const Vec3q30& direction)
    {
        return {1, {detail::nearest(lattice, direction)}, {detail::kWeightOneQ12}};
    }
};

// Weights are barycentric in the lattice triangles of both sides: 3 × 3 texels a pixel. They are continuous for
// lattices of every size, see triangle(); by spans but for what these leave out.
struct Linear {
    static constexpr uint32_t kTaps = 3;
    static detail::Taps<kTaps> taps(const detail::Lattice& lattice, const Vec3q30& direction)
    {
        const detail::Triangle t = detail::triangle(lattice, direction);
        return {kTaps, {t.index[0], t.index[1], t.index[2]}, {t.weight_q12[0], t.weight_q12[1], t.weight_q12[2]}};
    }
};

// Takes the paper's kernel over the K nearest points of each side: up to K × K texels a pixel; those beyond its radius
// weigh nothing and are not read. Its radius is the paper's, the fall-off of its weights is ours.
template <uint32_t K = 5>
struct Paper {
    static_assert(K >= 1 && K <= detail::kMaxNeighbours, "the paper's kernel takes 1 to 9 neighbours a side");
    static constexpr uint32_t kTaps = K;
    static detail::Taps<kTaps> taps(const detail::Lattice& lattice, const Vec3q30& direction)
    {
        detail::Neighbour near[K];
        detail::Taps<K> result;
        result.count = detail::kernel_points(lattice, direction, K, near);
        for (uint32_t k = 0; k < result.count; ++k) result.index[k] = near[k].index;
        detail::kernel_weights(lattice, near, result.count, result.weight_q12);
        return result;
    }
};

}  // namespace lumi

namespace lumi::detail
{

// Sums of weighted texels, Q24: at most 255·2^24 each, since the weights of both sides sum to 2^12 and r, g, b <= a.
struct Gathered {
    uint32_t r = 0, g = 0, b = 0, a = 0;

    void add(uint32_t weight_q24, const Rgba8& texel)
    {
        r += weight_q24 * texel.r;
        g += weight_q24 * texel.g;
        b += weight_q24 * texel.b;
        a += weight_q24 * texel.a;
    }

    // Lays the premultiplied sums over a background.
    Rgb8 over(const Rgb8& background) const
    {
        constexpr uint32_t kOneQ24 = 1u << 24;
        const uint32_t transparency_q24 = kOneQ24 - a / 255u;
        return {blended<24>(r, transparency_q24, background.r), blended<24>(g, transparency_q24, background.g),
                blended<24>(b, transparency_q24, background.b)};
    }
};

// Other ways of finding texels take this seam: a pixel's hits come in, its sums go out. Origins outside the cap count
// as misses.
template <class Reconstruction, class Texel>
Gathered gather(const Field& field, const Vec3q30& front, const Vec3q30& back)
{
    constexpr uint32_t kTaps = Reconstruction::kTaps;
    const Taps<kTaps> origins = Reconstruction::taps(field.origins, front);
    const Taps<kTaps> directions = Reconstruction::taps(field.directions, back);
    Gathered sums;
    for (uint32_t m = 0; m < origins.count; ++m) {
        const uint8_t* row = field.row(origins.index[m]);
        if (row == nullptr) continue;
        LUMI_TALLY(Work::tap, directions.count);
        for (uint32_t k = 0; k < directions.count; ++k)
            sums.add(origins.weight_q12[m] * directions.weight_q12[k], Texel::load(field, row, directions.index[k]));
    }
    return sums;
}

}  // namespace lumi::detail
