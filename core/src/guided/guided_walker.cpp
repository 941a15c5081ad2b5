// SPDX-License-Identifier: MIT
#include "lumi/guided/guided_walker.h"

namespace lumi
{
namespace
{

int32_t segment_begin(int32_t ahead, int log2)
{
    return ahead & ~((1 << log2) - 1);
}

// One pixel's triangle without stepping.
OriginTaps exact_triangle(const Camera& camera, const Lattice& origins, int32_t x, int32_t y)
{
    SphereRay ray;
    // The outline's borders may differ from the ray's by a rounding: then no origin is known.
    if (!ray_at(camera, x, y, ray)) return {{-1, -1, -1}, {0, 0, 0}};
    const Triangle t = triangle(origins, hits(camera, ray).front);
    OriginTaps taps;
    for (int k = 0; k < 3; ++k) taps.index[k] = static_cast<int32_t>(t.index[k]);
    taps.weight_q8[1] = t.weight_q12[1] >> 4;
    taps.weight_q8[2] = t.weight_q12[2] >> 4;
    taps.weight_q8[0] = 256 - taps.weight_q8[1] - taps.weight_q8[2];
    return taps;
}

}  // namespace

OriginWalker::OriginWalker(const Camera& camera, const Lattice& origins)
    : cell_{},
      camera_(camera),
      origins_(origins),
      lattice_(origins),
      nodes_(camera),
      track_(lattice_, &HitPair::front),
      walker_(track_)
{
}

void OriginWalker::begin_row(const RowSpan& covered, int32_t y)
{
    covered_ = covered;
    y_ = y;
    end_x_ = INT32_MIN;
    node_[0].ahead = node_[1].ahead = -1;
}

// The longest segment that holds a pixel: dyadic, and not much longer than its distance from either rim. 0 where there
// is none, also at the last pixel.
int OriginWalker::longest_log2(int32_t ahead) const
{
    const int32_t last = covered_.end - covered_.begin - 1;
    int log2 = kMaxSpanLog2;
    for (; log2 > 0; --log2) {
        const int32_t begin = segment_begin(ahead, log2);
        const int32_t length = 1 << log2;
        const int32_t to_right = (last - begin + 2) / 2;
        if (length <= begin + 2 && length <= to_right && begin + length <= last) break;
    }
    return log2;
}

// The node at a pixel of the row: one of the last two, or evaluated in the place of the one that is not `keep`.
const OriginWalker::Node& OriginWalker::node_at(int32_t ahead, const Node* keep)
{
    for (const Node& n : node_)
        if (n.ahead == ahead) return n;
    Node& n = keep == &node_[0] ? node_[1] : node_[0];
    nodes_.evaluate_front(ahead, n.node);
    n.ahead = ahead;
    return n;
}

// Makes walker_ ready for a segment and returns its length; or how long it may be at most.
int32_t OriginWalker::length_at(int32_t begin, int log2)
{
    const bool at_last = begin == covered_.end - covered_.begin - 1;
    const Node& at = node_at(begin, nullptr);
    const Node& next = at_last ? at : node_at(begin + (1 << log2), &at);
    walker_.begin(at.node);
    return walker_.prepare(at.node, next.node, 1 << log2);
}

bool OriginWalker::set_segment(int32_t begin, int32_t length)
{
    const CellLine& line = track_.line.cells;
    begin_x_ = cap_x_ = covered_.begin + begin;
    end_x_ = begin_x_ + length;
    key_ = kNoKey;
    cell_ = {{line.first, line.second, line.base, line.flip, line.flip_mask},
             line.u_q16,
             line.v_q16,
             line.du_q16,
             line.dv_q16};
    kind_ = track_.line.over_pole ? Kind::cap : Kind::cells;
    if (!track_.line.over_pole) return false;
    polar_ = track_.line.polar;
    return set_cap();
}

// Returns whether the corners changed already: those of cells are set pixel by pixel.
bool OriginWalker::begin_segment(int32_t ahead)
{
    if (nodes_y_ != y_) {
        nodes_.begin_row(covered_.begin, y_);
        nodes_y_ = y_;
    }
    for (int log2 = longest_log2(ahead); log2 >= 0;) {
        const int32_t begin = segment_begin(ahead, log2);
        const int32_t fits = length_at(begin, log2);
        if (fits == 1 << log2) return set_segment(begin, fits);
        do --log2;
        while (log2 >= 0 && 1 << log2 > fits);
    }
    kind_ = Kind::exact;
    begin_x_ = covered_.begin + ahead;
    end_x_ = begin_x_ + 1;
    return false;
}

__attribute__((noinline)) bool OriginWalker::begin_and_move(int32_t x)
{
    const bool begun_elsewhere = begin_segment(x - covered_.begin);
    return move_within(x) || begun_elsewhere;
}

bool OriginWalker::set_index(int k, int32_t index)
{
    const bool differs = taps_.index[k] != index;
    taps_.index[k] = index;
    return differs;
}

// The corners of a cell's triangle; `upper` is all ones for the one where v is above u.
bool OriginWalker::set_cell(int32_t corner, int32_t upper)
{
    const CellSteps& s = cell_.steps;
    const int32_t near = s.base + corner;
    const int32_t middle = near + s.first + ((s.second - s.first) & upper);
    const bool differs[3] = {set_index(0, near), set_index(1, middle), set_index(2, near + s.first + s.second)};
    return differs[0] || differs[1] || differs[2];
}

// A triangle of a cell that is cut along the difference of its steps.
bool OriginWalker::move_to_flipped(int32_t corner, int32_t u_q16, int32_t v_q16)
{
    key_ = kNoKey;
    const CellSteps& s = cell_.steps;
    const int32_t fu = (u_q16 >> 8) & 255;
    const int32_t fv = (v_q16 >> 8) & 255;
    const int32_t over = fu + fv - 256;
    const int32_t weight[3] = {over < 0 ? -over : over, over < 0 ? fu : 256 - fv, over < 0 ? fv : 256 - fu};
    for (int k = 0; k < 3; ++k) taps_.weight_q8[k] = static_cast<uint32_t>(weight[k]);
    const int32_t near = s.base + corner;
    const bool differs[3] = {set_index(0, over < 0 ? near : near + s.first + s.second), set_index(1, near + s.first),
                             set_index(2, near + s.second)};
    return differs[0] || differs[1] || differs[2];
}

// The corners of the cap's triangle.
bool OriginWalker::set_cap()
{
    bool differs = false;
    for (int k = 0; k < 3; ++k) differs |= set_index(k, polar_.index(k));
    return differs;
}

bool OriginWalker::step_over_cap(int32_t x)
{
    // Where the pixel before lies in the triangle, so do all up to it.
    const int32_t n = x - 1 - cap_x_;
    const auto before = [&](int k) { return polar_.weight_q16[k] + n * polar_.step_q16[k]; };
    if ((before(0) | before(1) | before(2)) >= 0) {
        cap_x_ = x;
        polar_.find(x - begin_x_);
    }
    for (; cap_x_ < x; ++cap_x_) polar_.advance(cap_x_ + 1 - begin_x_);
    set_cap_weights(polar_.weight_q16[1], polar_.weight_q16[2]);
    return set_cap();
}

bool OriginWalker::move_to_exact(int32_t x)
{
    key_ = kNoKey;
    const OriginTaps taps = exact_triangle(camera_, origins_, x, y_);
    bool differs = false;
    for (int k = 0; k < 3; ++k) {
        differs |= set_index(k, taps.index[k]);
        taps_.weight_q8[k] = taps.weight_q8[k];
    }
    return differs;
}

}  // namespace lumi
