// SPDX-License-Identifier: MIT
// The origin triangle of every pixel of a row, stepped between exact hits (walker.h) where pixels need it.
//
// A row is cut into segments of up to 16 pixels at places that depend on the camera alone, and a segment is always
// walked from its first pixel. So a pixel's triangle does not depend on which other pixels are drawn: any rectangle
// of the image shows the same bits.
#pragma once

#include "lumi/detail/register_hints.h"
#include "lumi/detail/stepping/walker.h"
#include "lumi/guided/guided_origin.h"
#include "lumi/sphere.h"

namespace lumi
{

// Where a line's lattice steps lead.
struct CellSteps {
    int32_t first, second, base;
    int32_t flip, flip_mask;

    // Index of a cell's lowest corner from `base`.
    int32_t corner(int32_t u_q16, int32_t v_q16) const { return first * (u_q16 >> 16) + second * (v_q16 >> 16); }
    // Whether the diagonal of the cell at a corner is the difference of both steps.
    bool is_flipped(int32_t corner) const { return ((corner - flip) ^ flip_mask) < 0; }
};

class OriginWalker
{
public:
    OriginWalker(const Camera& camera, const Lattice& origins);
    OriginWalker(const OriginWalker&) = delete;
    OriginWalker& operator=(const OriginWalker&) = delete;

    // Goes to row y, whose pixels `covered` of the whole image hit the sphere.
    void begin_row(const RowSpan& covered, int32_t y);

    // Sets taps() to the triangle around where pixel x of `covered` enters the sphere; x increases along a row. Returns
    // whether its corners are others than the last pixel's. About 40 instructions, 27 over a pole's cap, and 25 for
    // segments.
    LUMI_ALWAYS_INLINE bool move_to(int32_t x)
    {
        if (__builtin_expect(x >= end_x_, false)) return begin_and_move(x);
        return move_within(x);
    }

    const OriginTaps& taps() const { return taps_; }

private:
    enum class Kind : uint8_t { cells, cap, exact };
    static constexpr uint32_t kNoKey = 1u << 31;  // of a cell 2^14 away

    struct Cells {
        CellSteps steps;
        int32_t u_q16, v_q16, du_q16, dv_q16;  // at the segment's first pixel
    };
    struct Node {
        HitPair node;
        int32_t ahead = -1;  // of the row; -1: none
    };

    // move_to() in a segment that has begun.
    LUMI_ALWAYS_INLINE bool move_within(int32_t x)
    {
        if (kind_ == Kind::cap) return move_over_cap(x);
        if (__builtin_expect(kind_ != Kind::cells, false)) return move_to_exact(x);
        const uint32_t n = static_cast<uint32_t>(x - begin_x_);
        const auto stepped = [&](int32_t start, int32_t step) {
            return static_cast<int32_t>(static_cast<uint32_t>(start) + n * static_cast<uint32_t>(step));
        };
        const int32_t u_q16 = stepped(cell_.u_q16, cell_.du_q16);
        const int32_t v_q16 = stepped(cell_.v_q16, cell_.dv_q16);
        const int32_t fv = (v_q16 >> 8) & 255;
        const int32_t difference = ((u_q16 >> 8) & 255) - fv;
        const int32_t upper = difference >> 31;  // all ones where fu < fv
        // Cells number less than 2^14 either way.
        const uint32_t cell = (static_cast<uint32_t>(u_q16) & 0xFFFF0000u) | static_cast<uint32_t>(v_q16) >> 16;
        const uint32_t key = 2 * cell - static_cast<uint32_t>(upper);
        bool moved = false;
        if (__builtin_expect(key != key_, false)) {
            const int32_t corner = cell_.steps.corner(u_q16, v_q16);
            if (__builtin_expect(cell_.steps.is_flipped(corner), false)) return move_to_flipped(corner, u_q16, v_q16);
            key_ = key;
            moved = set_cell(corner, upper);
        }
        return set_weights(difference, upper, fv, moved);
    }

    // Of the triangle's corners in a cell, where fu - fv is `difference`. Passes `moved` on.
    LUMI_ALWAYS_INLINE bool set_weights(int32_t difference, int32_t upper, int32_t fv, bool moved)
    {
        const int32_t between = (difference ^ upper) - upper;
        const int32_t less = fv + (difference & upper);
        taps_.weight_q8[0] = static_cast<uint32_t>(256 - less - between);
        taps_.weight_q8[1] = static_cast<uint32_t>(between);
        taps_.weight_q8[2] = static_cast<uint32_t>(less);
        return moved;
    }

    // The weights that cap_ holds for column cap_x_, moved on; where one has turned negative on the way, step by step.
    LUMI_ALWAYS_INLINE bool move_over_cap(int32_t x)
    {
        const int32_t n = x - cap_x_;
        const int32_t near_q16 = polar_.weight_q16[0] + n * polar_.step_q16[0];
        const int32_t middle_q16 = polar_.weight_q16[1] + n * polar_.step_q16[1];
        const int32_t far_q16 = polar_.weight_q16[2] + n * polar_.step_q16[2];
        if (__builtin_expect((near_q16 | middle_q16 | far_q16) < 0, false)) return step_over_cap(x);
        set_cap_weights(middle_q16, far_q16);
        return false;
    }

    // Of weights that sum to 2^16: the rounded ones do not sum to more than 2^8.
    LUMI_ALWAYS_INLINE void set_cap_weights(int32_t middle_q16, int32_t far_q16)
    {
        const uint32_t middle = (static_cast<uint32_t>(middle_q16) + 128) >> 8;
        const uint32_t far = static_cast<uint32_t>(far_q16) >> 8;
        taps_.weight_q8[0] = 256 - middle - far;
        taps_.weight_q8[1] = middle;
        taps_.weight_q8[2] = far;
    }

    bool begin_and_move(int32_t x);
    bool begin_segment(int32_t ahead);
    int longest_log2(int32_t ahead) const;
    const Node& node_at(int32_t ahead, const Node* keep);
    int32_t length_at(int32_t begin, int log2);
    bool set_segment(int32_t begin, int32_t length);
    bool set_cell(int32_t corner, int32_t upper);
    bool move_to_flipped(int32_t corner, int32_t u_q16, int32_t v_q16);
    bool step_over_cap(int32_t x);
    bool set_cap();
    bool move_to_exact(int32_t x);
    bool set_index(int k, int32_t index);

    // What every pixel needs comes first: Armv6-M reads 124 bytes beyond an object's address in one instruction.
    // The segment, as columns of the image; the triangle, in a cell or over a pole, that taps_ holds; and how cells are
    // stepped.
    int32_t begin_x_ = 0, end_x_ = 0;
    uint32_t key_ = kNoKey;
    Kind kind_ = Kind::exact;
    OriginTaps taps_{{-1, -1, -1}, {0, 0, 0}};
    Cells cell_;
    PolarLine polar_{};
    int32_t cap_x_ = 0;  // the column whose weights cap_ holds
    RowSpan covered_{0, 0};
    int32_t y_ = 0, nodes_y_ = INT32_MIN;
    const Camera& camera_;
    const Lattice& origins_;
    LatticeZones lattice_;
    RowHits nodes_;
    LatticeTrack track_;
    LineWalker walker_;
    Node node_[2];
};

}  // namespace lumi
