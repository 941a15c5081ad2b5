// SPDX-License-Identifier: MIT
// Mean colours: the trilinear colour of sparse voxels at a surface point.
//
// A mean policy has `kFormat`, `kHasMean` and a node's colour as two words to sum; MeanReader reads one field's voxels
// with it. Colours leave as levels of 0 .. 255 in Q8.
#pragma once

#include "lumi/detail/chord/sums.h"
#include "lumi/detail/register_hints.h"
#include "lumi/guided/guided_field.h"
#include "lumi/guided/guided_registers.h"
#include "lumi/guided/surface_point.h"

namespace lumi
{

struct LevelsQ8 {
    int32_t r, g, b;
};

// Weighted sums of nodes: red and blue apart, and all channels where the node has them. Green is the difference.
struct MeanSum {
    uint32_t rb = 0, all = 0;
};

struct MeanRgb565 {
    static constexpr bool kHasMean = true;
    static constexpr format::MeanFormat kFormat = format::MeanFormat::rgb565;
    static constexpr uint32_t kNodeBytes = 2;
    static constexpr int kWeightBits = 6;  // what fits between blue and red, where they are

    LUMI_ALWAYS_INLINE static void add(const MeanColours&, const uint8_t* node, uint32_t weight, MeanSum& sum)
    {
        const uint32_t v = load_aligned<uint16_t>(node);
        sum.rb += (v & 0xF81Fu) * weight;
        sum.all += v * weight;
    }
    // 255/31 and 255/63 in Q8 of sums with 6 bits of weight: within 0.7 level of unpack_rgb565, which repeats high
    // bits.
    LUMI_ALWAYS_INLINE static LevelsQ8 levels(const MeanSum& sum)
    {
        constexpr uint32_t kFive = 2106, kSix = 1036;  // times 4 over 2^8
        return {static_cast<int32_t>((sum.rb >> 11) * kFive >> 6),
                static_cast<int32_t>(((sum.all - sum.rb) >> 5) * kSix >> 6),
                static_cast<int32_t>((sum.rb & 0x7FFu) * kFive >> 6)};
    }
};

struct MeanPalette8 {
    static constexpr bool kHasMean = true;
    static constexpr format::MeanFormat kFormat = format::MeanFormat::palette8;
    static constexpr uint32_t kNodeBytes = 1;
    static constexpr int kWeightBits = 8;

    LUMI_ALWAYS_INLINE static void add(const MeanColours& mean, const uint8_t* node, uint32_t weight, MeanSum& sum)
    {
        const uint32_t rgb = load_aligned<uint32_t>(mean.palette + 4u * *node);
        sum.rb += (rgb & 0x00FF00FFu) * weight;
        sum.all += rgb * weight;
    }
    // A palette's fourth byte, 0 by format, lies above green's 16 bits.
    LUMI_ALWAYS_INLINE static LevelsQ8 levels(const MeanSum& sum)
    {
        return {static_cast<int32_t>(sum.rb & 0xFFFFu), static_cast<int32_t>((sum.all - sum.rb) >> 8 & 0xFFFFu),
                static_cast<int32_t>(sum.rb >> 16)};
    }
};

// The chart's colours are absolute.
struct NoMean {
    static constexpr bool kHasMean = false;
};

template <class Mean>
class MeanReader
{
public:
    explicit MeanReader(const MeanColours& mean)
        : mean_(mean),
          resolution_(static_cast<int32_t>(mean.resolution)),
          stride_{1, mean.box[0], static_cast<uint32_t>(mean.box[0]) * mean.box[1]}
    {
        for (int k = 0; k < 3; ++k) {
            origin_q15_[k] = (resolution_ << 14) - mean.first_brick[k] * (4 << 15);
            last_[k] = 4 * mean.box[k] - 1;
        }
    }

    // About 150 instructions.
    LUMI_ALWAYS_INLINE LevelsQ8 at(const SurfacePoint& x) const
    {
        const uint64_t words = words_at(x.x_q14, x.y_q14, x.z_q14);
        return Mean::levels({static_cast<uint32_t>(words), static_cast<uint32_t>(words >> 32)});
    }

private:
    static constexpr uint32_t kOne = 1u << Mean::kWeightBits;

    // Of the four edges along x, by (y, z), and the share of each edge's far node. They sum to kOne.
    struct Weights {
        uint32_t edge[4];
        uint32_t far_q8;

        LUMI_ALWAYS_INLINE Weights(uint32_t fx, uint32_t fy, uint32_t fz) : far_q8(fx)
        {
            constexpr int kDown = 8 - Mean::kWeightBits;
            const uint32_t y = (fy + (1u << kDown >> 1)) >> kDown, z = (fz + (1u << kDown >> 1)) >> kDown;
            edge[3] = (y * fz + 128) >> 8;
            edge[2] = z - edge[3];
            edge[1] = y - edge[3];
            edge[0] = kOne - y - edge[2];
        }
        LUMI_ALWAYS_INLINE uint32_t far(int k) const { return (edge[k] * far_q8 + 128) >> 8; }
    };

    static uint32_t bits(int32_t v) { return static_cast<uint32_t>(v); }

    // The sums as two words, which stay in registers across the call.
    __attribute__((noinline)) uint64_t words_at(int32_t x_q14, int32_t y_q14, int32_t z_q14) const
    {
        // Node coordinates in the box: (x + 1)·resolution/2 less the box's first, Q8 below 2^16.
        const auto position = [&](int32_t q14, int k) { return (q14 * resolution_ + origin_q15_[k]) >> 7; };
        const int32_t px = position(x_q14, 0), py = position(y_q14, 1), pz = position(z_q14, 2);
        const int32_t nx = px >> 8, ny = py >> 8, nz = pz >> 8;
        if (bits(nx) >= bits(last_[0]) || bits(ny) >= bits(last_[1]) || bits(nz) >= bits(last_[2]))
            return words_at_border(px, py, pz);
        return words_of(sum_at(nx, ny, nz, Weights(bits(px & 255), bits(py & 255), bits(pz & 255))));
    }

    static uint64_t words_of(const MeanSum& sum) { return static_cast<uint64_t>(sum.all) << 32 | sum.rb; }

    LUMI_ALWAYS_INLINE MeanSum sum_at(int32_t nx, int32_t ny, int32_t nz, const Weights& w) const
    {
        const uint32_t place = bits(nx >> 2) + stride_[1] * bits(ny >> 2) + stride_[2] * bits(nz >> 2);
        const uint32_t node = bits(nx & 3) + 4 * bits(ny & 3) + 16 * bits(nz & 3);
        // 1 where the next node along an axis lies in the next brick.
        const uint32_t beyond_x = bits((nx & 3) + 1) >> 2;
        const uint32_t beyond_y = bits((ny & 3) + 1) >> 2, beyond_z = bits((nz & 3) + 1) >> 2;
        const uint32_t brick_y = beyond_y * stride_[1], brick_z = beyond_z * stride_[2];
        const uint32_t node_y = 4 - 16 * beyond_y, node_z = 16 - 64 * beyond_z;
        MeanSum sum;
        if ((beyond_y | beyond_z) == 0) {
            const uint8_t* const near = brick(place) + node * Mean::kNodeBytes;
            const uint8_t* const far = beyond_x == 0 ? near + Mean::kNodeBytes : next_in_row(place, node);
            add_edge_at(near, far, 0, w, 0, sum);
            add_edge_at(near, far, 4, w, 1, sum);
            add_edge_at(near, far, 16, w, 2, sum);
            add_edge_at(near, far, 20, w, 3, sum);
        } else if (beyond_x == 0) {
            add_edge(place, node, w, 0, sum);
            add_edge(place + brick_y, node + node_y, w, 1, sum);
            add_edge(place + brick_z, node + node_z, w, 2, sum);
            add_edge(place + brick_y + brick_z, node + node_y + node_z, w, 3, sum);
        } else {
            add_cut_edge(place, node, w, 0, sum);
            add_cut_edge(place + brick_y, node + node_y, w, 1, sum);
            add_cut_edge(place + brick_z, node + node_z, w, 2, sum);
            add_cut_edge(place + brick_y + brick_z, node + node_y + node_z, w, 3, sum);
        }
        return sum;
    }

    LUMI_ALWAYS_INLINE const uint8_t* brick(uint32_t place) const
    {
        const uint32_t number = load_aligned<uint16_t>(mean_.index + 2 * place);
        return mean_.bricks + number * (format::kBrickNodes * Mean::kNodeBytes);
    }

    // The node after `node`, the last of its row in a brick.
    LUMI_ALWAYS_INLINE const uint8_t* next_in_row(uint32_t place, uint32_t node) const
    {
        return brick(place + 1) + (node - 3) * Mean::kNodeBytes;
    }

    // An edge along x whose nodes lie `nodes` after two of the same bricks.
    LUMI_ALWAYS_INLINE void add_edge_at(const uint8_t* near_node, const uint8_t* far_node, uint32_t nodes,
                                        const Weights& w, int k, MeanSum& sum) const
    {
        const uint32_t far = w.far(k);
        Mean::add(mean_, near_node + nodes * Mean::kNodeBytes, w.edge[k] - far, sum);
        settle(sum.rb, sum.all);
        Mean::add(mean_, far_node + nodes * Mean::kNodeBytes, far, sum);
        settle(sum.rb, sum.all);
    }

    // Both nodes of an edge along x in one brick.
    LUMI_ALWAYS_INLINE void add_edge(uint32_t place, uint32_t node, const Weights& w, int k, MeanSum& sum) const
    {
        const uint8_t* const at = brick(place) + node * Mean::kNodeBytes;
        add_edge_at(at, at + Mean::kNodeBytes, 0, w, k, sum);
    }

    // The far node in the next brick.
    LUMI_ALWAYS_INLINE void add_cut_edge(uint32_t place, uint32_t node, const Weights& w, int k, MeanSum& sum) const
    {
        add_edge_at(brick(place) + node * Mean::kNodeBytes, next_in_row(place, node), 0, w, k, sum);
    }

    // Beside the box nodes are clamped one by one; no X on a well-baked surface comes here.
    __attribute__((noinline)) uint64_t words_at_border(int32_t px, int32_t py, int32_t pz) const
    {
        const Weights w(bits(px & 255), bits(py & 255), bits(pz & 255));
        const int32_t nx = px >> 8, ny = py >> 8, nz = pz >> 8;
        MeanSum sum;
        for (int k = 0; k < 4; ++k) {
            const uint32_t far = w.far(k);
            Mean::add(mean_, clamped_node(nx, ny + (k & 1), nz + (k >> 1)), w.edge[k] - far, sum);
            Mean::add(mean_, clamped_node(nx + 1, ny + (k & 1), nz + (k >> 1)), far, sum);
        }
        return words_of(sum);
    }

    const uint8_t* clamped_node(int32_t nx, int32_t ny, int32_t nz) const
    {
        const auto clamped = [&](int32_t n, int k) { return n < 0 ? 0 : n > last_[k] ? last_[k] : n; };
        const int32_t x = clamped(nx, 0), y = clamped(ny, 1), z = clamped(nz, 2);
        const uint32_t place = bits(x >> 2) + stride_[1] * bits(y >> 2) + stride_[2] * bits(z >> 2);
        return brick(place) + bits((x & 3) + 4 * (y & 3) + 16 * (z & 3)) * Mean::kNodeBytes;
    }

    MeanColours mean_;
    int32_t resolution_;
    uint32_t stride_[3];
    int32_t origin_q15_[3];  // node coordinates in the box of the sphere's centre
    int32_t last_[3];        // of the box's nodes along each axis
};

}  // namespace lumi
