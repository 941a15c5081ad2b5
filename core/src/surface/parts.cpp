// SPDX-License-Identifier: MIT
// Frames with moving parts: where these are, and what changes when they move.
#include "lumi/surface/parts.h"

#include "surface/fill.h"
#include "surface/moving.h"
#include "surface/order.h"

namespace lumi
{
namespace
{

using namespace detail;

constexpr int kQ20ToQ14 = 6;

// Columns of the turn, Q30, and what it and the slide move the sphere's centre by.
struct Motion {
    int32_t column[3][3];
    Vec3q20 offset;
};

int32_t narrowed(int64_t v_q30)
{
    return static_cast<int32_t>((v_q30 + (int64_t{1} << 29)) >> 30);
}

// The inverse of a turn: the product of its columns with a vector.
template <class Vector>
int32_t along(const int32_t (&column)[3], const Vector& v)
{
    return narrowed(wide_product(column[0], v.x) + wide_product(column[1], v.y) + wide_product(column[2], v.z));
}

// By Rodrigues' formula the turn about the axis a is cos·I + (1 - cos)·a aᵀ + sin·[a]×.
Motion turn(const PartMotion& part, uint32_t turns32)
{
    const SinCos angle = sin_cos(turns32);
    const int32_t a[3] = {part.axis.x, part.axis.y, part.axis.z};
    const auto entry = [&](int row, int column) {
        const int64_t scaled = (static_cast<int64_t>(kOneQ30) - angle.cos_q30) * a[row] >> 30;
        const int64_t both_q60 = scaled * a[column];
        if (row == column) return narrowed(both_q60 + wide_product(angle.cos_q30, kOneQ30));
        const int64_t across_q60 = wide_product(angle.sin_q30, a[3 - row - column]);
        return narrowed(column == (row + 1) % 3 ? both_q60 - across_q60 : both_q60 + across_q60);
    };
    Motion m{};
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) m.column[column][row] = entry(row, column);
    const Vec3q20& c = part.pivot;
    const auto left = [&](int row, int32_t at) {
        const int32_t turned[3] = {m.column[0][row], m.column[1][row], m.column[2][row]};
        return at - along(turned, c);
    };
    m.offset = {left(0, c.x), left(1, c.y), left(2, c.z)};
    return m;
}

Motion slide(const PartMotion& part, int32_t offset_q20)
{
    const auto scaled = [&](int32_t axis) { return narrowed(wide_product(axis, offset_q20)); };
    return {{{kOneQ30, 0, 0}, {0, kOneQ30, 0}, {0, 0, kOneQ30}},
            {scaled(part.axis.x), scaled(part.axis.y), scaled(part.axis.z)}};
}

// The eye as the part has it. One number or more of 14 bits takes a bit more each time it is doubled.
void move_viewer(const Motion& m, SurfaceProjection& p)
{
    constexpr int32_t kMost = 1 << 14;
    const int shift = kQ20ToQ14 + p.viewer_shift;
    const VertexQ14 eye = {p.viewer.x - (m.offset.x >> shift), p.viewer.y - (m.offset.y >> shift),
                           p.viewer.z - (m.offset.z >> shift)};
    VertexQ14 v = {along(m.column[0], eye), along(m.column[1], eye), along(m.column[2], eye)};
    while (most_of(magnitude(v.x), magnitude(v.y), magnitude(v.z)) > kMost) {
        v = {v.x >> 1, v.y >> 1, v.z >> 1};
        ++p.viewer_shift;
    }
    p.viewer = v;
}

// Makes the projection of the body that of a part. At the value 0 it is the same to the bit.
void move(SurfaceProjection& p, const PartMotion& part, uint32_t value)
{
    constexpr int64_t kMostEye = 0x5F000000;  // with a vertex's sum, below 2^29 + 2^20, it stays below 2^31
    if (value == 0) return;
    const Motion m = part.slides ? slide(part, static_cast<int32_t>(value)) : turn(part, value);
    for (int k = 0; k < 3; ++k) {
        const Vec3q30 row = {p.axis[k][0], p.axis[k][1], p.axis[k][2]};
        const int64_t sum =
            wide_product(row.x, m.offset.x) + wide_product(row.y, m.offset.y) + wide_product(row.z, m.offset.z);
        const int shift = kQ20ToQ14 + p.shift[k];
        const int64_t eye = p.eye[k] + ((sum + (int64_t{1} << (shift - 1))) >> shift);
        p.eye[k] = static_cast<int32_t>(eye < -kMostEye ? -kMostEye : eye < kMostEye ? eye : kMostEye);
        for (int j = 0; j < 3; ++j) p.axis[k][j] = along(m.column[j], row);
    }
    if (!part.light_stays) move_viewer(m, p);
}

struct __attribute__((may_alias)) ProjectionWords {
    uint32_t word[sizeof(SurfaceProjection) / sizeof(uint32_t)];
};

bool are_same(const SurfaceProjection& a, const SurfaceProjection& b)
{
    const auto &left = reinterpret_cast<const ProjectionWords&>(a),
               &right = reinterpret_cast<const ProjectionWords&>(b);
    for (uint32_t k = 0; k < sizeof left.word / sizeof left.word[0]; ++k)
        if (left.word[k] != right.word[k]) return false;
    return true;
}

bool is_nothing(const PixelBounds& b)
{
    return b.left >= b.right || b.top >= b.bottom;
}

PixelBounds bounds_of(const SurfaceFrame& frame)
{
    const auto pixel = [](int32_t v) { return static_cast<uint16_t>(v); };
    return {pixel(frame.columns.begin), pixel(frame.scanlines.begin), pixel(frame.columns.end),
            pixel(frame.scanlines.end)};
}

PixelBounds joined(const PixelBounds& a, const PixelBounds& b)
{
    if (is_nothing(a)) return b;
    if (is_nothing(b)) return a;
    const auto least = [](uint16_t v, uint16_t w) { return v < w ? v : w; };
    const auto most = [](uint16_t v, uint16_t w) { return v > w ? v : w; };
    return {least(a.left, b.left), least(a.top, b.top), most(a.right, b.right), most(a.bottom, b.bottom)};
}

SurfaceParts& parts_of(const SurfaceFrame& frame)
{
    return moving_parts(frame.field, frame.memory);
}

// By the frame's projection, with the extents that they have.
__attribute__((noinline)) void place(SurfaceFrame& frame, const OwnerRanges& owner)
{
    PlacedVertices placed = kNothingPlaced;
    place_vertices(frame, owner.viewed, placed);
    place_vertices(frame, owner.plain, placed);
    set_extents(frame, placed);
}

// Before all that the lists hold.
__attribute__((noinline)) void list(SurfaceFrame& frame, const NumberRange& patches)
{
    Lister<light> lister(frame, frame.memory.bands);
    for (uint32_t k = patches.begin; k < patches.end; ++k) lister.add(k, surface_patch(frame.field, k).corner);
    if (lister.reach() > frame.reach) frame.reach = lister.reach();
}

// Takes the parts' triangles out of the lists: they stand before the body's, whose numbers are lower.
void unlist(const SurfaceFrame& frame)
{
    const uint32_t first = 2 * patches_of_parts(frame).begin;
    uint16_t* const bands = frame.memory.bands;
    for (uint32_t k = 0; k <= frame.other_list; ++k) {
        uint32_t triangle = bands[k];
        while (triangle != kEmptyBand && triangle >= first) triangle = after(triangle, frame.memory.links[triangle]);
        bands[k] = static_cast<uint16_t>(triangle);
    }
}

}  // namespace

void detail::place_cut(const SurfaceFrame& frame, CutTriangle& cut)
{
    if (!may_move(frame.field, frame.memory)) return;
    for (uint32_t part = frame.field.part_count; part-- > 0;) {
        if (!owner_ranges(frame.field, part + 1).has_vertex(cut.vertex[0])) continue;
        const SurfaceProjection& own = moving_part(parts_of(frame), part).projection;
        for (int k = 0; k < 3; ++k) cut.view[k] = moved_point(own, surface_vertex(frame.field, cut.vertex[k]));
    }
}

void detail::place_vertices(const SurfaceFrame& frame, const NumberRange& vertices, PlacedVertices& placed)
{
    LUMI_TALLY(Work::vertex, vertices.end - vertices.begin);
    for (uint32_t k = vertices.begin; k < vertices.end; ++k) {
        const SurfaceProjection& projection = frame.projection;
        const SamplePoint p = projected(projection, moved_point(projection, surface_vertex(frame.field, k)));
        frame.memory.vertices[k] = packed(p, kUnlit);
        placed.are_whole = placed.are_whole && p.depth != 0;
        add(placed.x_q6, p.x_q6);
        add(placed.y_q6, p.y_q6);
    }
}

void detail::rest_parts(const SurfaceField& field, const SurfaceMemory& memory)
{
    if (!may_move(field, memory)) return;
    SurfaceParts& parts = moving_parts(field, memory);
    parts = {};
    for (uint32_t k = 0; k < field.part_count; ++k) moving_part(parts, k) = {};
}

PatchRange detail::patches_of_parts(const SurfaceFrame& frame)
{
    return {owner_ranges(frame.field, 1).patches.begin, frame.field.patch_count};
}

MovingStart detail::begin_moving(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode,
                                 const SurfaceMemory& memory, SurfaceFrame& out)
{
    SurfaceParts& parts = moving_parts(field, memory);
    const bool has_frame = parts.has_frame && out.width_px == camera.width_px && out.height_px == camera.height_px;
    const bool has_body = has_frame && parts.has_body && out.mode == mode;
    parts.before =
        has_frame ? bounds_of(out)
                  : PixelBounds{0, 0, static_cast<uint16_t>(camera.width_px), static_cast<uint16_t>(camera.height_px)};
    SurfaceProjection before{};
    if (has_body) before = out.projection;
    set_frame(field, camera, mode, memory, out);
    const bool shows = set_projection(camera, out);
    parts.has_frame = true;
    parts.has_body = shows;
    parts.keeps_body = has_body && shows && are_same(before, out.projection);
    if (parts.keeps_body) return MovingStart::kept_body;
    empty_frame(out);
    return shows ? MovingStart::new_body : MovingStart::nothing_shows;
}

void detail::put_body(SurfaceFrame& frame)
{
    const OwnerRanges body = owner_ranges(frame.field, 0);
    place(frame, body);
    list(frame, body.patches);
}

// A part that has not moved keeps its vertices, but it is listed again. While a part is listed, the frame has its
// projection: lit_colour() reads that.
void detail::put_parts(SurfaceFrame& frame, bool keeps_body)
{
    SurfaceParts& parts = parts_of(frame);
    if (keeps_body) {
        unlist(frame);
    } else {
        parts.body = bounds_of(frame);
        parts.reach = static_cast<uint8_t>(frame.reach);
    }
    frame.reach = parts.reach;
    parts.moved = 0;
    const SurfaceProjection body = frame.projection;
    const bool is_whole = frame.is_whole;
    PixelBounds all = parts.body;
    for (uint32_t k = 0; k < frame.field.part_count; ++k) {
        SurfacePart& part = moving_part(parts, k);
        const OwnerRanges owner = owner_ranges(frame.field, k + 1);
        frame.projection = body;
        if (const uint32_t leader = followed(frame.field, k); leader != 0)
            part.value = moving_part(parts, leader - 1).value;
        move(frame.projection, part_motion(frame.field, k), part.value);
        part.shown_before = part.shown;
        frame.is_whole = frame.is_narrow = false;  // where it is not known
        if (!keeps_body || !are_same(part.projection, frame.projection)) {
            part.projection = frame.projection;
            parts.moved = static_cast<uint16_t>(parts.moved | 1u << k);
            place(frame, owner);
            part.shown = bounds_of(frame);
        }
        list(frame, owner.patches);
        all = joined(all, part.shown);
    }
    frame.projection = body;
    frame.is_whole = is_whole && frame.field.part_count == mover_count(frame.field);  // shadows are not known
    frame.columns = {all.left, all.right};
    frame.scanlines = {all.top, all.bottom};
}

LUMI_HOT bool detail::MovingPieces::next()
{
    if (piece.is_wide && next_part_of_wide(piece)) return true;
    for (uint32_t triangle = 0; next_listed(walk_, frame_, triangle);)
        if (begin_whole(piece, frame_, triangle, target_)) return true;
    return next_cut();
}

LUMI_HOT bool detail::MovingSeeThroughPieces::next()
{
    return next_of(
        [&](uint32_t triangle) __attribute__((always_inline)) {
            begin_cut(cut_, frame_, triangle);
            place_cut(frame_, cut_);
        });
}

__attribute__((noinline)) bool detail::MovingPieces::next_cut()
{
    while (true) {
        if (begin_piece(piece, frame_, cut_, target_)) return true;
        if (other_ == kEmptyBand) return false;
        begin_cut(cut_, frame_, other_);
        place_cut(frame_, cut_);
        other_ = after(other_, frame_.memory.links[other_]);
    }
}

namespace
{

bool set_value(const SurfaceField& field, const SurfaceMemory& memory, uint32_t part, uint32_t value)
{
    moving_part(moving_parts(field, memory), part).value = value;
    return true;
}

bool can_move(const SurfaceField& field, const SurfaceMemory& memory, uint32_t part, bool slides)
{
    return may_move(field, memory) && part < mover_count(field) && part_motion(field, part).slides == slides;
}

}  // namespace

bool turn_part(const SurfaceField& field, const SurfaceMemory& memory, uint32_t part, uint32_t turns32)
{
    if (!can_move(field, memory, part, false)) return false;
    const PartMotion m = part_motion(field, part);
    const uint32_t from = static_cast<uint32_t>(m.from), beyond = turns32 - from;
    if (beyond > m.span) turns32 = beyond - m.span < 0 - beyond ? from + m.span : from;
    return set_value(field, memory, part, turns32);
}

bool slide_part(const SurfaceField& field, const SurfaceMemory& memory, uint32_t part, int32_t offset_q20)
{
    if (!can_move(field, memory, part, true)) return false;
    const PartMotion m = part_motion(field, part);
    const int32_t to = static_cast<int32_t>(m.from + int64_t{m.span});
    const int32_t within = offset_q20 < m.from ? m.from : offset_q20 < to ? offset_q20 : to;
    return set_value(field, memory, part, static_cast<uint32_t>(within));
}

namespace
{

// Rectangles of pixels that are apart or not: more of them than a frame tells are joined.
class Rects
{
public:
    Rects(const SurfaceFrame& frame, uint32_t align_x, uint32_t align_y)
        : width_(static_cast<uint32_t>(frame.width_px)),
          height_(static_cast<uint32_t>(frame.height_px)),
          align_x_(align_x == 0 ? 1 : align_x),
          align_y_(align_y == 0 ? 1 : align_y)
    {
    }

    void add(const PixelBounds& b)
    {
        if (is_nothing(b)) return;
        const auto end = [](uint32_t at, uint32_t align, uint32_t size) {
            const uint32_t over = at % align, to_next = over == 0 ? 0 : align - over;
            return static_cast<uint16_t>(to_next < size - at ? at + to_next : size);
        };
        const auto begin = [](uint32_t at, uint32_t align) { return static_cast<uint16_t>(at - at % align); };
        rect_[count_++] = {begin(b.left, align_x_), begin(b.top, align_y_), end(b.right, align_x_, width_),
                           end(b.bottom, align_y_, height_)};
    }

    ChangedRects merged()
    {
        while (merge()) {
        }
        ChangedRects result{};
        for (; result.count < count_; ++result.count) {
            const PixelBounds& b = rect_[result.count];
            result.rect[result.count] = {b.left, b.top, b.right - b.left, b.bottom - b.top};
        }
        return result;
    }

private:
    static int32_t area(const PixelBounds& b) { return (b.right - b.left) * (b.bottom - b.top); }

    // Joins the two whose common rectangle adds least, if that adds nothing or there are too many; else false.
    bool merge()
    {
        uint32_t first = 0, second = 0;
        int32_t least = count_ > ChangedRects::kMost ? INT32_MAX : 1;
        for (uint32_t a = 0; a < count_; ++a) {
            for (uint32_t b = a + 1; b < count_; ++b) {
                const int32_t added = area(joined(rect_[a], rect_[b])) - area(rect_[a]) - area(rect_[b]);
                if (added >= least) continue;
                least = added;
                first = a;
                second = b;
            }
        }
        if (first == second) return false;
        rect_[first] = joined(rect_[first], rect_[second]);
        rect_[second] = rect_[--count_];
        return true;
    }

    const uint32_t width_, height_, align_x_, align_y_;
    PixelBounds rect_[format::kMaxParts];
    uint32_t count_ = 0;
};

}  // namespace

ChangedRects changed_rects(const SurfaceFrame& frame, uint32_t align_x, uint32_t align_y)
{
    Rects rects(frame, align_x, align_y);
    if (!may_move(frame.field, frame.memory)) {
        rects.add({0, 0, static_cast<uint16_t>(frame.width_px), static_cast<uint16_t>(frame.height_px)});
        return rects.merged();
    }
    SurfaceParts& parts = parts_of(frame);
    if (!parts.keeps_body) rects.add(joined(parts.before, bounds_of(frame)));
    for (uint32_t k = 0; parts.keeps_body && k < frame.field.part_count; ++k) {
        const SurfacePart& part = moving_part(parts, k);
        if ((parts.moved >> k & 1) != 0) rects.add(joined(part.shown_before, part.shown));
    }
    return rects.merged();
}

}  // namespace lumi
