// SPDX-License-Identifier: MIT
#include "lumi/outline.h"

#include "lumi/math.h"

namespace lumi
{
namespace
{

int64_t magnitude(int64_t v)
{
    return v < 0 ? -v : v;
}

// The largest magnitude of an affine quantity over the image: it lies at a corner.
int64_t largest(const AffineQ40& a, const Camera& camera)
{
    const int32_t right = camera.width_px - 1;
    const int32_t bottom = camera.height_px - 1;
    int64_t most = 0;
    const int64_t corners[] = {a.at(0, 0), a.at(right, 0), a.at(0, bottom), a.at(right, bottom)};
    for (const int64_t v : corners) {
        if (magnitude(v) > most) most = magnitude(v);
    }
    return most;
}

// Adds factor·(a.at_origin + x·a.step_x + y·a.step_y)² >> shift to the polynomial; factor Q30, a below 2^30.
void add_square(OutlineQuadratic& f, int64_t origin, int64_t dx, int64_t dy, int32_t factor_q30, int shift)
{
    const auto term = [&](int64_t product) { return multiply_shift(product, factor_q30, 30) >> shift; };
    f.constant += term(origin * origin);
    f.x1 += term(2 * origin * dx);
    f.y1 += term(2 * origin * dy);
    f.x2 += term(dx * dx);
    f.xy += term(2 * dx * dy);
    f.y2 += term(dy * dy);
}

}  // namespace

OutlineQuadratic make_outline(const Camera& camera)
{
    int64_t most = 1;
    for (const AffineQ40& a : camera.offset) {
        const int64_t m = largest(a, camera);
        if (m > most) most = m;
    }
    // P in Q(40 - shift) below 2^28; three squares and their cross terms stay below 2^61.
    int shift = 12;
    while ((most >> shift) >= int64_t{1} << 28) ++shift;
    constexpr int kFacingShift = 12;
    constexpr int32_t kTangent = kOneQ30 >> kTangentShift;
    const int32_t inverse2_q30 = kOneQ30 - camera.perpendicular_q30;
    const int32_t factor_q30 = camera.perpendicular_q30 + (inverse2_q30 >> kTangentShift);

    OutlineQuadratic f{};
    for (const AffineQ40& a : camera.offset) {
        add_square(f, a.at_origin >> shift, a.step_x >> shift, a.step_y >> shift, -factor_q30, 0);
    }
    const AffineQ40& m = camera.facing;
    add_square(f, m.at_origin >> kFacingShift, m.step_x >> kFacingShift, m.step_y >> kFacingShift, kOneQ30 - kTangent,
               2 * (shift - kFacingShift));
    return f;
}

OutlineTracker::OutlineTracker(const Camera& camera, const RowSpan& limits)
    : camera_(camera),
      outline_(make_outline(camera)),
      limits_{limits.begin > 0 ? limits.begin : 0, limits.end < camera.width_px ? limits.end : camera.width_px},
      span_{0, 0},
      last_y_(INT32_MIN)
{
}

void OutlineTracker::Walk::right()
{
    f += df;
    df += ddf;
    m += dm;
}

void OutlineTracker::Walk::left()
{
    df -= ddf;
    f -= df;
    m -= dm;
}

OutlineTracker::Walk OutlineTracker::walk_at(int32_t x, int32_t y) const
{
    const int64_t slope = outline_.x1 + y * outline_.xy;
    const int64_t f = outline_.constant + y * (outline_.y1 + y * outline_.y2) + x * (slope + x * outline_.x2);
    return {f, slope + (2 * x + 1) * outline_.x2, 2 * outline_.x2, camera_.facing.at(x, y), camera_.facing.step_x};
}

// Moves both ends of the last span to row y; false if no covered pixel lies between them.
bool OutlineTracker::follow(int32_t y)
{
    int32_t begin = span_.begin;
    Walk left = walk_at(begin, y);
    if (left.covered()) {
        for (left.left(); begin > limits_.begin && left.covered(); left.left()) --begin;
    } else {
        while (begin < span_.end && !left.covered()) {
            ++begin;
            left.right();
        }
        if (begin == span_.end) return false;
    }
    int32_t end = span_.end;
    Walk right = walk_at(end - 1, y);
    if (right.covered()) {
        for (right.right(); end < limits_.end && right.covered(); right.right()) ++end;
    } else {
        for (; !right.covered(); right.left()) --end;
    }
    span_ = {begin, end};
    return true;
}

RowSpan OutlineTracker::row(int32_t y)
{
    const bool follows = span_.begin < span_.end && y == last_y_ + 1 && y < camera_.height_px;
    if (!follows || !follow(y)) span_ = covered_span(camera_, y, limits_.begin, limits_.end);
    last_y_ = y;
    return span_;
}

}  // namespace lumi
