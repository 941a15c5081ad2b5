// SPDX-License-Identifier: MIT
#include "planner/surface_work.h"

#include <cmath>
#include <vector>

#include "lumi/surface/see_through.h"
#include "surface/begin.h"
#include "surface/lists.h"
#include "surface/rows/row_loops.h"
#include "surface/see_through/order.h"
#include "surface/see_through/rows.h"
#include "surface/sides.h"
#include "surface/silhouette.h"
#include "surface/wide.h"

namespace lumi::planner
{

namespace
{

using detail::Filter;
using detail::Rows;

// What the loops add to, which take nothing but rows.
thread_local SurfaceWork* counted = nullptr;

void add(SurfaceItem item, double count = 1)
{
    (*counted)[item] += count;
}

// Items of a loop: opaque or see-through triangles, textures that are read bilinearly or not.
struct LoopItems {
    SurfaceItem loop, row, filled, sample, shown, clamped, rim, blended;
};
constexpr LoopItems kPlain = {SurfaceItem::loop,  SurfaceItem::row,     SurfaceItem::filled, SurfaceItem::sample,
                              SurfaceItem::shown, SurfaceItem::clamped, SurfaceItem::rim,    SurfaceItem::blended};
constexpr LoopItems kMagnified = {SurfaceItem::magnified_loop,
                                  SurfaceItem::magnified_row,
                                  SurfaceItem::magnified_filled,
                                  SurfaceItem::magnified_sample,
                                  SurfaceItem::magnified_shown,
                                  SurfaceItem::clamped,
                                  SurfaceItem::rim,
                                  SurfaceItem::blended};
constexpr LoopItems kSeePlain = {SurfaceItem::see_loop,   SurfaceItem::see_row,    SurfaceItem::see_filled,
                                 SurfaceItem::see_sample, SurfaceItem::see_shown,  SurfaceItem::see_clamped,
                                 SurfaceItem::see_rim,    SurfaceItem::see_blended};
constexpr LoopItems kSeeMagnified = {SurfaceItem::see_loop,
                                     SurfaceItem::see_row,
                                     SurfaceItem::see_filled,
                                     SurfaceItem::see_magnified_sample,
                                     SurfaceItem::see_magnified_shown,
                                     SurfaceItem::see_clamped,
                                     SurfaceItem::see_rim,
                                     SurfaceItem::see_blended};

// Of a sample that is read bilinearly: whether its texels differ, and whether they lie at their rectangle's rim.
struct FourTexelsKind {
    bool differ, at_rim;

    FourTexelsKind(uint32_t place, const Rows& rows)
    {
        const detail::FourTexels t = detail::texels_around(place, rows);
        const uint8_t first = t.upper[t.left];
        differ = t.upper[t.right] != first || t.lower[t.left] != first || t.lower[t.right] != first;
        const uint32_t column = ((place & 0xFFFF) - 512) >> 10, row = ((place >> 16) - 512) >> 10;
        at_rim = column >= rows.columns - 1 || row >= rows.texel_rows - 1;
    }
};

// Samples as core keeps them, opaque ones and those behind see-through triangles.
struct Pixels {
    using Drawn = detail::Sample565<PixelRgb565>;
    using Blended = detail::Blended565<PixelRgb565, false>;
};
struct Packed {
    using Drawn = detail::BlendedPacked;
    using Blended = detail::BlendedPacked;
};

// Counts a row's samples, and then draws them.
template <class Samples, const LoopItems& kItems, Filter kFilter, bool kIsSeeThrough>
void count_samples(uint16_t* first, const uint16_t* end, typename Samples::Drawn::Colour* colours, uint32_t first_depth,
                   uint32_t first_place, detail::PackedColour first_colour, const Rows& rows)
{
    uint32_t depth = first_depth, place = first_place, colour = first_colour;
    uint32_t shown = 0, alone = 0, different = 0, at_rim = 0, clamped = 0;
    for (const uint16_t* at = first; at != end; ++at) {
        if (depth >> 16 > *at) {
            ++shown;
            alone += *at < detail::kFarDepth;
            clamped += ((colour + detail::filtered<kFilter>(place, rows)) & detail::kGuardBits) != 0;
            if (kFilter == Filter::bilinear) {
                const FourTexelsKind kind(place, rows);
                different += kind.differ;
                at_rim += kind.at_rim;
            }
        }
        depth += rows.depth_right;
        place += rows.place_right;
        colour += rows.colour_right;
    }
    add(kItems.filled);
    add(kItems.sample, static_cast<double>(end - first));
    add(kItems.shown, shown);
    add(kItems.clamped, clamped);
    add(kItems.rim, at_rim);
    add(kItems.blended, different);
    if constexpr (kIsSeeThrough) {
        add(SurfaceItem::see_alone, alone);
        detail::blend_samples<typename Samples::Blended, kFilter>(first, end, colours, first_depth, first_place,
                                                                  first_colour, rows);
    } else {
        detail::draw_samples<typename Samples::Drawn, kFilter>(first, end, colours, first_depth, first_place,
                                                               first_colour, rows);
    }
}

template <class Samples, const LoopItems& kItems, Filter kFilter, bool kIsSeeThrough>
void count_rows(Rows& rows)
{
    add(kItems.loop);
    add(kItems.row, rows.count + rows.count_below);
    detail::draw_rows<typename Samples::Drawn, kFilter, count_samples<Samples, kItems, kFilter, kIsSeeThrough>>(rows);
}

// How many samples core looks at to know whether a triangle is hidden (src/surface/box.h); 0: its box has none.
uint32_t looked_at(const detail::Seen& s, const detail::Target& target)
{
    detail::Box box;
    if (!detail::set_box(box, *s.a, *s.b, *s.c, target)) return 0;
    const auto depth = [](const SurfaceVertex* v) { return static_cast<int32_t>(detail::depth_of(*v)); };
    const int32_t nearest = detail::most_of(depth(s.a), depth(s.b), depth(s.c));
    const int32_t least = detail::least_of(depth(s.a), depth(s.b), depth(s.c));
    const int32_t most = nearest + ((nearest - least) >> 6) + 2;
    uint32_t count = 0;
    for (int32_t y = box.first_row; y < box.end_row; ++y)
        for (int32_t x = box.first_column; x < box.end_column; ++x) {
            ++count;
            if (target.rows.depths(y - target.y)[x] < most) return count;
        }
    return count;
}

// Whether core looks at what a triangle's colour loses (src/surface/fill.cpp).
bool is_looked_at_for_colour(const detail::Seen& s, const detail::Target& target)
{
    detail::Box box;
    return detail::set_box(box, *s.a, *s.b, *s.c, target) && box.longer_q6 >= detail::kWideQ6 &&
           (s.a->colour | s.b->colour | s.c->colour) != 0;
}

// Begins a triangle as a whole; false if none of it shows.
bool begins(detail::TrianglePiece& piece, const SurfaceFrame& frame, uint32_t triangle, const detail::Target& target,
            SurfaceItem boxed, SurfaceItem looked, SurfaceItem begun)
{
    if (const uint32_t count = looked_at(detail::seen(frame, triangle), target); count != 0) {
        add(boxed);
        add(looked, count);
    }
    if (!detail::begin_whole(piece, frame, triangle, target)) return false;
    add(begun);
    if (is_looked_at_for_colour(detail::seen(frame, triangle), target)) add(SurfaceItem::wide_looked_at);
    return true;
}

// The parts of a large triangle. Each halving halves its area, so the parts that are drawn tell how much was dropped,
// and nearly how many steps that took.
class CountedParts
{
public:
    CountedParts(const SurfaceFrame& frame, const detail::Target& target) : frame_(frame), target_(target) {}

    void begin(uint32_t triangle)
    {
        add(SurfaceItem::large);
        detail::begin_parts(parts_, frame_, triangle);
        left_ = 1;
        ready_ = 0;
    }

    // False after the last.
    bool next(detail::TrianglePiece& piece)
    {
        if (parts_.count == 0) return false;
        detail::Corner corner[3];
        while (detail::next_part(parts_, frame_, target_, corner)) {
            ++ready_;
            left_ -= share_of(corner);
            detail::Box box;
            if (detail::set_box(box, *corner[0].at, *corner[1].at, *corner[2].at, target_) &&
                detail::begin_triangle(piece, corner, box, parts_.texture, target_)) {
                add(SurfaceItem::parts);
                return true;
            }
        }
        add(SurfaceItem::halved, 2 * (ready_ + dropped()) - 1);
        return false;
    }

private:
    // Of the triangle's area, a power of two.
    double share_of(const detail::Corner (&c)[3]) const
    {
        const auto area = [](double au, double av, double bu, double bv) { return std::fabs(au * bv - bu * av); };
        const double whole = area(parts_.u_q8[1] - parts_.u_q8[0], parts_.v_q8[1] - parts_.v_q8[0],
                                  parts_.u_q8[2] - parts_.u_q8[0], parts_.v_q8[2] - parts_.v_q8[0]);
        const double part =
            area(c[1].u_q8 - c[0].u_q8, c[1].v_q8 - c[0].v_q8, c[2].u_q8 - c[0].u_q8, c[2].v_q8 - c[0].v_q8);
        return part > 0 ? std::exp2(std::round(std::log2(part / whole))) : 0;
    }

    // Parts that lie beside the target, at least: a binary fraction has as many powers of two.
    int dropped() const
    {
        int count = 0;
        constexpr int kDeepest = 20;
        double rest = std::max(left_, 0.0);
        for (int k = 0; k <= kDeepest; ++k)
            if (const double power = std::exp2(-k); rest >= power) {
                rest -= power;
                ++count;
            }
        return count;
    }

    const SurfaceFrame& frame_;
    const detail::Target& target_;
    detail::Parts parts_;
    double left_ = 0;
    int ready_ = 0;
};

// Whether a wide triangle has another part.
bool goes_on(detail::TrianglePiece& piece)
{
    if (piece.is_wide) add(SurfaceItem::wide);
    return piece.is_wide && detail::next_part_of_wide(piece);
}

// As detail::TrianglePieces, counted.
class CountedPieces
{
public:
    CountedPieces(const SurfaceFrame& frame, const detail::Target& target)
        : piece(target),
          frame_(frame),
          target_(target),
          walk_(detail::walk_of(frame, target)),
          other_(frame.memory.bands[frame.other_list]),
          parts_(frame, target)
    {
    }

    bool next()
    {
        if (goes_on(piece)) return true;
        for (uint32_t triangle = 0; detail::next_listed(walk_, frame_, triangle);) {
            add(SurfaceItem::visited);
            if (begins(piece, frame_, triangle, target_, SurfaceItem::boxed, SurfaceItem::looked_at,
                       SurfaceItem::begun))
                return true;
        }
        return next_part();
    }

    detail::TrianglePiece piece;

private:
    bool next_part()
    {
        while (true) {
            if (parts_.next(piece)) return true;
            if (other_ == detail::kEmptyBand) return false;
            parts_.begin(other_);
            other_ = detail::after(other_, frame_.memory.links[other_]);
        }
    }

    const SurfaceFrame& frame_;
    const detail::Target& target_;
    detail::ListWalk walk_;
    uint32_t other_;
    CountedParts parts_;
};

// As detail::SeeThroughPieces.
class CountedSeeThrough
{
public:
    CountedSeeThrough(const SeeThroughFrame& frame, const detail::Target& target)
        : piece(target), frame_(frame), target_(target), parts_(frame, target)
    {
    }

    bool next()
    {
        if (goes_on(piece)) return true;
        while (true) {
            if (parts_.next(piece)) return true;
            if (at_ == frame_.order_count) return false;
            const uint32_t entry = frame_.order[at_++], triangle = detail::triangle_of(entry);
            add(SurfaceItem::see_visited);
            if ((entry & detail::kInParts) != 0)
                parts_.begin(triangle);
            else if (begins(piece, frame_, triangle, target_, SurfaceItem::see_boxed, SurfaceItem::see_looked_at,
                            SurfaceItem::see_begun))
                return true;
        }
    }

    detail::TrianglePiece piece;

private:
    const SeeThroughFrame& frame_;
    const detail::Target& target_;
    uint32_t at_ = 0;
    CountedParts parts_;
};

// Lines of samples that an edge crosses within a target (src/surface/cut_pixels.h).
int32_t lines_of(const SurfaceVertex& a, const SurfaceVertex& b, const detail::Target& target)
{
    const int32_t dx = detail::x_q6(b) - detail::x_q6(a), dy = detail::y_q6(b) - detail::y_q6(a);
    const bool is_steep = std::abs(dy) >= std::abs(dx);
    const auto along = [&](const SurfaceVertex& v) {
        return is_steep ? detail::y_q6(v) - 64 * target.y : detail::x_q6(v) - 64 * target.x;
    };
    const auto across = [&](const SurfaceVertex& v) {
        return is_steep ? detail::x_q6(v) - 64 * target.x : detail::y_q6(v) - 64 * target.y;
    };
    const int32_t count = is_steep ? target.rows.height : target.rows.width;
    const int32_t wide = 64 * (is_steep ? target.rows.width : target.rows.height);
    const int32_t begin = detail::line_from(std::min(along(a), along(b))),
                  end = detail::line_from(std::max(along(a), along(b)));
    const int32_t first = std::max(begin, 0), last = std::min(end, count);
    const bool is_beside = (across(a) < 0 && across(b) < 0) || (across(a) > wide && across(b) > wide);
    return is_beside ? 0 : std::max(last - first, 0);
}

void count_sides(const SurfaceFrame& frame, uint32_t triangle, uint32_t sides, const detail::Target& target,
                 SurfaceItem line)
{
    add(SurfaceItem::outline);
    const detail::Seen s = detail::seen(frame, triangle);
    if (!detail::reaches(*s.a, *s.b, *s.c, target)) return;
    const detail::SurfacePatch patch = detail::surface_patch(frame.field, triangle >> 1);
    const SurfaceVertex* const v = frame.memory.vertices;
    for (uint32_t n = 0; n < 3; ++n) {
        if ((sides >> n & 1) == 0) continue;
        const detail::Side side = detail::side_of(patch, triangle, n);
        if (!detail::is_there(v[side.from]) || !detail::is_there(v[side.to])) continue;
        add(SurfaceItem::edge);
        add(line, lines_of(v[side.from], v[side.to], target));
    }
}

void count_outlines(const SurfaceFrame& frame, const detail::Target& target)
{
    const auto count = [&](uint32_t triangle) {
        if (const uint32_t sides = detail::outline_sides_of(frame, triangle); sides != 0)
            count_sides(frame, triangle, sides, target, SurfaceItem::line);
    };
    detail::ListWalk walk = detail::walk_of(frame, target);
    for (uint32_t triangle = 0; detail::next_listed(walk, frame, triangle);) count(triangle);
    for (uint32_t other = frame.memory.bands[frame.other_list]; other != detail::kEmptyBand;) {
        count(other);
        other = detail::after(other, frame.memory.links[other]);
    }
}

void count_see_through_outlines(const SeeThroughFrame& frame, const detail::Target& target)
{
    for (uint32_t k = 0; k < frame.order_count; ++k) {
        if ((frame.order[k] & detail::kHasOutline) == 0) continue;
        const uint32_t triangle = detail::triangle_of(frame.order[k]);
        const detail::SurfacePatch patch = detail::surface_patch(frame.field, triangle >> 1);
        uint32_t sides = 0;
        for (uint32_t n = 0; n < 3; ++n) sides |= (detail::is_outline(frame, patch, triangle, n) ? 1u : 0u) << n;
        count_sides(frame, triangle, sides, target, SurfaceItem::see_line);
    }
}

template <class Samples, Filter kPlainFilter, Filter kMagnifiedFilter>
void count_triangles(const SeeThroughFrame& frame, const detail::Target& target)
{
    CountedPieces pieces(frame, target);
    detail::draw_pieces<count_rows<Samples, kPlain, kPlainFilter, false>,
                        count_rows<Samples, kMagnified, kMagnifiedFilter, false>>(pieces, target);
    if (frame.order_count == 0) return;
    detail::Target over = target;
    over.palette = frame.added_and_passed;
    CountedSeeThrough see_through(frame, over);
    detail::draw_pieces<count_rows<Samples, kSeePlain, kPlainFilter, true>,
                        count_rows<Samples, kSeeMagnified, kMagnifiedFilter, true>>(see_through, over);
}

void count_marks(const detail::StripeSamples& s)
{
    add(SurfaceItem::marked_row, s.part.bottom_px - s.part.top_px);
    for (int32_t y = s.part.top_px; y < s.part.bottom_px; ++y)
        detail::each_marked(s.rows, s.row(y), s.begin(), s.end(), [](int32_t) { add(SurfaceItem::marked); });
}

// Whether mean_of() of these goes by their light (surface/detail/packed_colour.h).
bool is_light_averaged(detail::PackedColour a, detail::PackedColour b, detail::PackedColour c, detail::PackedColour d)
{
    constexpr detail::PackedColour kApart = detail::packed_colour(128, 128, 128), kBeyond = 0xE01C0380;
    const detail::PackedColour from = a + kApart;
    return (((from - b) | (from - c) | (from - d)) & kBeyond) != 0;
}

void count_fours(const detail::StripeSamples& s)
{
    for (int32_t y = s.part.top_px; y < s.part.bottom_px; ++y) {
        const int32_t row = 2 * s.row(y);
        const uint16_t *upper = s.rows.depths(row), *lower = s.rows.depths(row + 1);
        const auto *above = s.rows.colours<detail::PackedColour>(row),
                   *below = s.rows.colours<detail::PackedColour>(row + 1);
        for (int32_t x = 2 * s.begin(); x < 2 * s.end(); x += 2) {
            const int with = (upper[x] != 0) + (upper[x + 1] != 0) + (lower[x] != 0) + (lower[x + 1] != 0);
            if (with == 0) continue;
            add(with == 4 ? SurfaceItem::whole_px : SurfaceItem::mixed_px);
            if (with == 4 && is_light_averaged(above[x], above[x + 1], below[x], below[x + 1]))
                add(SurfaceItem::apart_px);
        }
    }
}

void count_stripe(const SeeThroughFrame& frame, const Stripe& stripe, void* memory)
{
    add(SurfaceItem::stripe);
    const detail::DrawnPart part = detail::drawn_part(frame, stripe);
    if (part.is_empty()) return;
    add(SurfaceItem::part_px, part.rect.width_px * part.rect.height_px);
    const detail::SampleRows rows = detail::samples_of(frame, part, frame.samples_are_pixels, memory);
    const detail::StripeSamples samples = {frame, rows, part, stripe};
    detail::clear_pixels(rows, 0);
    if (frame.samples_log2 != 0) detail::clear_depths(rows);
    if (frame.samples_log2 != 0 && frame.order_count != 0) {
        add(SurfaceItem::see_sample_px, rows.width * rows.height);
        detail::fill_colours<PixelRgb565>(samples, OverBlack());
    }
    const detail::Target target = detail::target_of(frame, part, rows);
    if (frame.mode == SurfaceMode::antialiased)
        count_triangles<Pixels, Filter::two_taps, Filter::bilinear>(frame, target);
    else if (frame.mode == SurfaceMode::two_by_two)
        count_triangles<Packed, Filter::nearest, Filter::bilinear>(frame, target);
    else
        count_triangles<Pixels, Filter::nearest, Filter::nearest>(frame, target);
    if (frame.margin != 0) {
        count_outlines(frame, target);
        count_see_through_outlines(frame, target);
        detail::mark_outlines(frame, target);
        if (frame.order_count != 0) detail::mark_see_through_outlines(frame, target);
        count_marks(samples);
    }
    if (frame.mode == SurfaceMode::two_by_two) count_fours(samples);
}

void count_preparing(const SeeThroughField& field, const SeeThroughFrame& frame)
{
    add(SurfaceItem::frame);
    add(SurfaceItem::vertex, field.vertex_count);
    add(SurfaceItem::patch, field.patch_count);
    add(SurfaceItem::image_px, 1.0 * frame.width_px * frame.height_px);
    for (uint32_t k = 0; k < 2u * field.patch_count; ++k)
        if (frame.memory.links[k] < detail::kWithoutSamples) add(SurfaceItem::listed);
    if (frame.margin != 0) add(SurfaceItem::bordered, field.patch_count);
    for (uint32_t k = 0; k < field.vertex_count; ++k) {
        if (frame.memory.vertices[k].colour == detail::kUnlit) continue;
        add(SurfaceItem::cornered);
        if (k < field.viewed_count) add(SurfaceItem::lit);
    }
    add(SurfaceItem::see_frame, field.see_through_count != 0 ? 1 : 0);
    add(SurfaceItem::see_patch, field.see_through_count);
    add(SurfaceItem::ordered, frame.order_count);
    if (frame.order_count > 1 && !field.is_in_order)
        add(SurfaceItem::sorted, frame.order_count * std::log2(frame.order_count));
}

}  // namespace

SurfaceWork work_of(const SeeThroughField& field, const tools::Eye& eye, SurfaceMode mode, int32_t stripe_rows)
{
    SurfaceWork work;
    SurfaceCamera camera;
    if (make_surface_camera(eye.pose, eye.image, camera) != CameraError::none) return work;
    const int32_t width = eye.image.width_px, height = eye.image.height_px;
    const uint32_t band_log2 = surface_band_log2(stripe_rows);
    std::vector<SurfaceVertex> vertices(field.vertex_count);
    std::vector<uint16_t> links(surface_links(field.patch_count)), bands(surface_bands(height, band_log2));
    std::vector<uint32_t> order(see_through_order(field.see_through_count)),
        samples(surface_stripe_bytes(width, stripe_rows, mode) / sizeof(uint32_t) + 1);
    SeeThroughFrame frame;
    prepare_surface<PixelRgb565>(field, camera, mode,
                                 {{vertices.data(), links.data(), bands.data(), band_log2}, order.data()}, frame);
    counted = &work;
    count_preparing(field, frame);
    for (int32_t y = 0; y < height; y += stripe_rows)
        count_stripe(frame, {nullptr, 0, y, width, std::min(stripe_rows, height - y), 0}, samples.data());
    return work;
}

}  // namespace lumi::planner
