// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/stepping/outline.h"

#include "lumi/detail/math.h"

namespace lumi::detail
{
namespace
{

// Steps along a side of one pixel are never taken, and could be longer than all else.
AffineQ40 within_image(const AffineQ40& a, const Camera& camera)
{
    return {a.at_first, camera.width_px() > 1 ? a.step_x : 0, camera.height_px() > 1 ? a.step_y : 0};
}

// The largest magnitude of an affine quantity over the image: it lies at a corner.
int64_t largest(const AffineQ40& a, const Camera& camera)
{
    const int32_t right = camera.width_px() - 1;
    const int32_t bottom = camera.height_px() - 1;
    int64_t most = 0;
    const int64_t corners[] = {a.at(0, 0), a.at(right, 0), a.at(0, bottom), a.at(right, bottom)};
    for (const int64_t v : corners)
        if (magnitude(v) > most) most = magnitude(v);
    return most;
}

// Adds factor·(a.at_first + x·a.step_x + y·a.step_y)² >> shift to the polynomial; factor Q30, a below 2^30.
void add_square(OutlineQuadratic& f, int64_t first, int64_t dx, int64_t dy, int32_t factor_q30, int shift)
{
    const auto term = [&](int64_t product) { return multiply_shift(product, factor_q30, 30) >> shift; };
    f.constant += term(first * first);
    f.x1 += term(2 * first * dx);
    f.y1 += term(2 * first * dy);
    f.x2 += term(dx * dx);
    f.xy += term(2 * dx * dy);
    f.y2 += term(dy * dy);
}

}  // namespace

OutlineQuadratic make_outline(const Camera& camera)
{
    int64_t most = 1;
    AffineQ40 offset[3];
    for (int k = 0; k < 3; ++k) {
        offset[k] = within_image(camera.offset()[k], camera);
        const int64_t m = largest(offset[k], camera);
        if (m > most) most = m;
    }
    // P in Q(40 - shift) below 2^28; three squares and their cross terms stay below 2^61.
    int shift = 12;
    while ((most >> shift) >= int64_t{1} << 28) ++shift;
    constexpr int kFacingShift = 12;
    constexpr int32_t kTangent = kOneQ30 >> kTangentShift;
    const int32_t inverse2_q30 = kOneQ30 - camera.perpendicular_q30();
    const int32_t factor_q30 = camera.perpendicular_q30() + (inverse2_q30 >> kTangentShift);

    OutlineQuadratic f{};
    for (const AffineQ40& a : offset)
        add_square(f, a.at_first >> shift, a.step_x >> shift, a.step_y >> shift, -factor_q30, 0);
    const AffineQ40 m = within_image(camera.facing(), camera);
    add_square(f, m.at_first >> kFacingShift, m.step_x >> kFacingShift, m.step_y >> kFacingShift, kOneQ30 - kTangent,
               2 * (shift - kFacingShift));
    return f;
}

// Returns those of a scanline's columns that lie in the image; none: {0, 0}.
static Extent within(const Extent& columns, int32_t width_px)
{
    const Extent inside = {columns.begin > 0 ? columns.begin : 0, columns.end < width_px ? columns.end : width_px};
    return inside.begin < inside.end ? inside : Extent{0, 0};
}

OutlineTracker::OutlineTracker(const Camera& camera, const Extent& limits)
    : camera_(camera), limits_(within(limits, camera.width_px())), span_{0, 0}, first_{}, last_{}, last_y_(INT32_MIN)
{
}

// Walks along a scanline by more than a pixel at a time; f and m are those of Walk, `right` is a stride's.
class OutlineTracker::Stride
{
public:
    Stride(const Camera& camera, int32_t step)
        : x2_(camera.outline().x2), bend_(x2_ * step * step), facing_(camera.facing().step_x * step), step_(step)
    {
    }

    Walk begin(Walk walk) const
    {
        walk.right = (walk.right - x2_) * step_ + bend_;
        return walk;
    }
    void move(Walk& walk) const
    {
        walk.f += walk.right;
        walk.right += 2 * bend_;
        walk.m += facing_;
    }

private:
    int64_t x2_, bend_, facing_;
    int32_t step_;
};

OutlineTracker::Walk OutlineTracker::at(int32_t x, int32_t y) const
{
    const OutlineQuadratic& o = camera_.outline();
    const int64_t slope = o.x1 + y * o.xy;
    const int64_t column = o.y1 + y * o.y2;
    return {o.constant + y * column + x * (slope + x * o.x2), slope + (2 * x + 1) * o.x2,
            column + (y + 1) * o.y2 + x * o.xy, camera_.facing().at(x, y)};
}

void OutlineTracker::move_right(Walk& walk) const
{
    walk.f += walk.right;
    walk.right += 2 * camera_.outline().x2;
    walk.down += camera_.outline().xy;
    walk.m += camera_.facing().step_x;
}

void OutlineTracker::move_left(Walk& walk) const
{
    walk.right -= 2 * camera_.outline().x2;
    walk.f -= walk.right;
    walk.down -= camera_.outline().xy;
    walk.m -= camera_.facing().step_x;
}

void OutlineTracker::move_down(Walk& walk) const
{
    walk.f += walk.down;
    walk.right += camera_.outline().xy;
    walk.down += 2 * camera_.outline().y2;
    walk.m += camera_.facing().step_y;
}

// Moves both walks along their scanline to the ends of its span; false if no covered pixel lies between them.
bool OutlineTracker::adjust()
{
    if (first_.covered()) {
        for (; span_.begin > limits_.begin; --span_.begin) {
            move_left(first_);
            if (first_.covered()) continue;
            move_right(first_);
            break;
        }
    } else {
        for (; !first_.covered(); ++span_.begin) {
            if (span_.begin + 1 >= span_.end) return false;
            move_right(first_);
        }
    }
    if (last_.covered()) {
        for (; span_.end < limits_.end; ++span_.end) {
            move_right(last_);
            if (last_.covered()) continue;
            move_left(last_);
            break;
        }
    } else {
        for (; !last_.covered(); --span_.end) move_left(last_);
    }
    return true;
}

// Looks for a scanline's span at 16 pixels or fewer of the limits.
bool OutlineTracker::search(int32_t y)
{
    if (y < 0 || y >= camera_.height_px() || limits_.begin >= limits_.end) return false;
    const int32_t step = 1 + (limits_.end - limits_.begin) / 16;
    const Stride stride(camera_, step);
    span_ = {limits_.end, limits_.begin};
    Walk walk = stride.begin(at(limits_.begin, y));
    int32_t highest = limits_.begin;
    int64_t highest_f = walk.f;
    for (int32_t x = limits_.begin; x < limits_.end; x += step, stride.move(walk)) {
        if (walk.f > highest_f) {
            highest_f = walk.f;
            highest = x;
        }
        if (!walk.covered()) continue;
        if (span_.begin > x) span_.begin = x;
        span_.end = x + 1;
    }
    if (span_.begin >= span_.end) {
        // Not concave, f is negative between two ends, of which m admits one: the scanline's first pixel was looked at.
        const int32_t likeliest = is_concave() ? top_between(highest - step, highest + step, y) : limits_.end - 1;
        span_ = {likeliest, likeliest + 1};
    }
    first_ = at(span_.begin, y);
    last_ = at(span_.end - 1, y);
    return first_.covered() && adjust();
}

// The pixel within the limits where the scanline's f is highest, which lies between both.
int32_t OutlineTracker::top_between(int32_t from, int32_t to, int32_t y) const
{
    if (from < limits_.begin) from = limits_.begin;
    if (to > limits_.end - 1) to = limits_.end - 1;
    while (from < to) {
        const int32_t middle = from + (to - from) / 2;
        if (at(middle, y).right > 0)
            from = middle + 1;
        else
            to = middle;
    }
    return from;
}

Extent OutlineTracker::scanline(int32_t y)
{
    bool found = span_.begin < span_.end && y == last_y_ + 1 && y < camera_.height_px();
    if (found) {
        move_down(first_);
        move_down(last_);
        found = adjust();
    }
    last_y_ = y;
    if (!found && !search(y)) span_ = {limits_.begin, limits_.begin};
    return span_;
}

// The first of `count` columns, `from` and on by `step`, that both scanlines cover; none: the one beyond the last.
int32_t OutlineTracker::find_column(int32_t top, int32_t bottom, int32_t from, int32_t step, int32_t count) const
{
    const Stride stride(camera_, step);
    Walk upper = stride.begin(at(from, top));
    Walk lower = stride.begin(at(from, bottom));
    int32_t x = from;
    for (; count > 0 && !(upper.covered() && lower.covered()); --count, x += step) {
        stride.move(upper);
        stride.move(lower);
    }
    return x;
}

Extent OutlineTracker::columns(int32_t top, int32_t bottom, const Extent& between, int step_log2) const
{
    const int32_t step = 1 << step_log2;
    const int32_t first = (between.begin + step - 1) & -step;
    const int32_t last = (between.end - 1) & -step;
    const int32_t count = (last - first) / step + 1;
    if (count < 2) return {0, 0};
    const int32_t begin = find_column(top, bottom, first, step, count);
    if (begin > last) return {0, 0};
    const int32_t end = find_column(top, bottom, last, -step, count);
    const auto reaches = [&](int32_t x) { return at(x, top).covered() && at(x, bottom).covered(); };
    const bool open_left = begin - step < limits_.begin && reaches(limits_.begin);
    const bool open_right = end + step >= limits_.end && reaches(limits_.end - 1);
    return {open_left ? begin : begin + step, open_right ? end : end - step};
}

}  // namespace lumi::detail
