// SPDX-License-Identifier: MIT
#include "planner/surface_work.h"

#include <cmath>
#include <vector>

#include "lumi/surface/detail/marks.h"
#include "planner/counted_rows.h"
#include "surface/lists.h"

namespace lumi::planner
{

namespace
{

using detail::Filter;

// Lines of samples that an edge crosses within a target (src/surface/outlines.cpp).
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
    const int32_t count = is_steep ? target.height : target.width;
    const int32_t wide = 64 * (is_steep ? target.width : target.height);
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
    if (!detail::reaches(s, target)) return;
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

void count_see_through_outlines(const SurfaceFrame& frame, const detail::Target& target)
{
    const uint32_t* const order = frame.memory.features;
    for (uint32_t k = 0; k < frame.see_through_triangles; ++k) {
        if ((order[k] & detail::kHasOutline) == 0) continue;
        const uint32_t triangle = detail::triangle_of(order[k]);
        const detail::SurfacePatch patch = detail::surface_patch(frame.field, triangle >> 1);
        uint32_t sides = 0;
        for (uint32_t n = 0; n < 3; ++n) sides |= (detail::is_outline(frame, patch, triangle, n) ? 1u : 0u) << n;
        count_sides(frame, triangle, sides, target, SurfaceItem::see_line);
    }
}

template <class Samples, Filter kPlainFilter, Filter kMagnifiedFilter>
void count_triangles(const SurfaceFrame& frame, const detail::Target& target)
{
    detail::draw_triangles<CountedPieces, count_rows<Samples, kPlain, kPlainFilter, false>,
                           count_rows<Samples, kMagnified, kMagnifiedFilter, false>>(frame, target);
    if (frame.see_through_triangles == 0) return;
    detail::draw_triangles<CountedSeeThrough, count_rows<Samples, kSeePlain, kPlainFilter, true>,
                           count_rows<Samples, kSeeMagnified, kMagnifiedFilter, true>>(frame, target);
}

void count_marks(const detail::StripeSamples& s)
{
    add(SurfaceItem::marked_row, s.covered.height_px);
    for (int32_t y = s.covered.y_px; y < s.covered.bottom_px(); ++y)
        detail::each_marked(s.target, s.row(y), s.begin(), s.end(), [](int32_t) { add(SurfaceItem::marked); });
}

// Samples without a margin, four a pixel.
void count_fours(const detail::Target& target)
{
    for (int32_t row = 0; row < target.height; row += 2) {
        const uint16_t *upper = target.depths(row), *lower = target.depths(row + 1);
        const auto *above = target.colours<detail::PackedColour>(row),
                   *below = target.colours<detail::PackedColour>(row + 1);
        for (int32_t x = 0; x < target.width; x += 2) {
            const int with = (upper[x] != 0) + (upper[x + 1] != 0) + (lower[x] != 0) + (lower[x + 1] != 0);
            if (with == 0) continue;
            add(with == 4 ? SurfaceItem::whole_px : SurfaceItem::mixed_px);
            if (with == 4 && detail::are_apart(above[x], above[x + 1], below[x], below[x + 1]))
                add(SurfaceItem::apart_px);
        }
    }
}

void count_stripe(const SurfaceFrame& frame, const Stripe& stripe, void* memory)
{
    add(SurfaceItem::stripe);
    const Stripe covered = detail::covered_part(frame, stripe, 0);
    if (covered.width_px == 0) return;
    const detail::Target target = detail::target_of(frame, covered, stripe.x_px, frame.samples_are_pixels, memory);
    const detail::StripeSamples samples = {frame, target, covered};
    add(SurfaceItem::part_px, (target.width >> frame.samples_log2) * (target.height >> frame.samples_log2));
    detail::clear_pixels(target, 0);
    if (frame.samples_log2 != 0) detail::clear_depths(target);
    if (frame.samples_log2 != 0 && frame.see_through_triangles != 0) {
        add(SurfaceItem::see_sample_px, target.width * target.height);
        detail::fill_colours<PixelRgb565>(samples, OverBlack());
    }
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
        if (frame.see_through_triangles != 0) detail::mark_see_through_outlines(frame, target);
        count_marks(samples);
    }
    if (frame.mode == SurfaceMode::two_by_two) count_fours(target);
}

void count_preparing(const SurfaceField& field, const SurfaceFrame& frame)
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
    add(SurfaceItem::ordered, frame.see_through_triangles);
    if (frame.see_through_triangles > 1 && !detail::is_in_order(field))
        add(SurfaceItem::sorted, frame.see_through_triangles * std::log2(frame.see_through_triangles));
}

}  // namespace

SurfaceWork work_of(const SurfaceField& field, const tools::Eye& eye, SurfaceMode mode, int32_t stripe_rows)
{
    SurfaceWork work;
    SurfaceCamera camera;
    if (make_surface_camera(eye.pose, eye.image, camera) != CameraError::none) return work;
    const int32_t width = eye.image.width_px, height = eye.image.height_px;
    const uint32_t band_log2 = surface_band_log2(stripe_rows);
    std::vector<SurfaceVertex> vertices(field.vertex_count);
    std::vector<uint16_t> links(surface_links(field.patch_count)), bands(surface_bands(height, band_log2));
    std::vector<uint32_t> see_through(feature_words(field)),
        samples(surface_stripe_bytes(width, stripe_rows, mode) / sizeof(uint32_t) + 1);
    SurfaceFrame frame;
    prepare_surface<PixelRgb565, SurfaceMode::two_by_two, SurfaceFeatures::all>(
        field, camera, mode, {vertices.data(), links.data(), bands.data(), band_log2, see_through.data()}, frame);
    counted = &work;
    count_preparing(field, frame);
    for (int32_t y = 0; y < height; y += stripe_rows)
        count_stripe(frame, {nullptr, 0, y, width, std::min(stripe_rows, height - y), 0}, samples.data());
    return work;
}

}  // namespace lumi::planner
