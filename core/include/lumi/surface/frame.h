// SPDX-License-Identifier: MIT
// A surface field seen by a camera: vertices on the image's grid of samples, lit for the eye; the triangles that are
// seen, in lists by bands of scanlines; the palette in the display's format. Made once a frame, read by every stripe
// (surface/render.h), also from several cores at once. Two cores prepare it together by surface/halves.h.
//
//     SurfaceCamera camera; make_surface_camera(pose, {240, 240, fov}, camera);
//     SurfaceFrame frame;   prepare_surface<PixelRgb565>(field, camera, SurfaceMode::one_sample, memory, frame);
//
// Depth is measured along the camera's forward axis. A buffer of depths holds kEmptyDepth, or a number from kFarDepth
// to kNearDepth that is affine in 1/depth and therefore in the image. The sphere makes the range, so several meshes in
// one sphere share it.
#pragma once
#pragma GCC system_header

#include "lumi/camera.h"
#include "lumi/stripe.h"
#include "lumi/surface/detail/target.h"
#include "lumi/surface/field.h"

namespace lumi::detail
{

inline constexpr uint32_t kEmptyDepth = 0;
inline constexpr uint32_t kFarDepth = 256;
inline constexpr uint32_t kNearDepth = 65279;  // rounding on the way never wraps 16 bits

// A gloss map has a colour for each byte, and a square disc of half vectors (surface/detail/gloss.h).
inline constexpr uint32_t kGlossColours = 256, kGlossDiscSide = 38, kGlossDiscBytes = kGlossDiscSide * kGlossDiscSide;

// A band has so many lists of triangles, by depth.
inline constexpr uint32_t kBandLists = 4;

// Leads from a vertex's numbers to the grid of samples; shifts and scales are chosen so that all fits 32 bits.
struct SurfaceProjection {
    int32_t axis[3][3];   // rows x, y, z: per unit of a vertex's number, kAxisBits
    int32_t shift[3];     // right, after the sum
    int32_t eye[3];       // added after the shift
    int32_t place_shift;  // x and y are shifted right by so much after the division
    int32_t centre_x_q6, centre_y_q6;
    int32_t near_z, far_z;  // ends of the range of depths, as z
    int32_t depth_bits;     // fraction bits of z
    int32_t ahead_shift;    // far_z - z is shifted right by so much, to 16 bits
    uint32_t depth_factor;  // 16 bits
    int32_t depth_shift;
    uint32_t depth_offset;  // a depth's number + this is proportional to 1/z
    int32_t straight_px;    // edges up to so long cannot look bent along their texture
    VertexQ14 viewer;       // the eye in the vertices' format, shifted right
    int32_t viewer_shift;
};

}  // namespace lumi::detail

namespace lumi
{

enum class SurfaceMode : uint8_t {
    one_sample,   // a pixel's centre
    antialiased,  // the same, with two taps of the texture, and outlines blended by coverage where the field has
                  // neighbours
    two_by_two,   // the mean light of four, at 1/4 and 3/4 of a pixel's sides
    // Where a texel is larger than three pixels, the last two read four texels and blend between their middles.
};

struct SurfaceCamera {
    Vec3q20 position;  // the eye, in the frame of the sphere
    Vec3q20 eye;       // the same along right, up and forward
    Vec3q30 right, up, forward;
    int32_t width_px, height_px;
    uint32_t focal_q12;                // pixels per unit of tangent, 0.28 .. 469,364
    int32_t centre_x_q8, centre_y_q8;  // where the optical axis meets the image, pixels
};

// Fills `out`, which stays untouched on failure. Takes what make_camera takes.
CameraError make_surface_camera(const Pose& pose, const Image& image, SurfaceCamera& out);

// Places a vertex on the grid of samples: 24 bits of x and y in 1/64 sample, and 16 bits of depth below them, 0 for a
// vertex nearer than the near plane or beside the guard band. `colour` has the view's share in 3 × 10 bits, see
// lit_colour.
struct SurfaceVertex {
    int32_t x, y;
    uint32_t colour;
};

// The caller gives this memory for a frame. It belongs to the frame as long as it is used; so do the field's bytes.
struct SurfaceMemory {
    SurfaceVertex* vertices;  // one for each vertex of the field
    uint16_t* links;          // surface_links(): of every triangle, then which of its sides are outlines
    uint16_t* bands;          // surface_bands()
    // Scanlines a band, 2^0 .. 2^8: see surface_band_log2. Where several
    // triangles have one depth, the bands decide which one shows.
    uint32_t band_log2;
    // feature_words() of the field, for see-through patches, moving parts and light states; for 0, and where no call
    // names these, null. Where parts move these words are 0 before the first frame, and they belong to the same frame
    // until the field or the format of pixels changes.
    uint32_t* features = nullptr;
};

// Counts the numbers for so many see-through patches: the order of their triangles, and their palette.
constexpr uint32_t see_through_words(uint32_t see_through_patches)
{
    return see_through_patches == 0 ? 0 : 2 * see_through_patches + 2 * detail::format::kPaletteEntries;
}

// Counts those of moving parts, 160 bytes each or less: what all of them share, then a part's own (surface/parts.h).
constexpr uint32_t part_words(uint32_t parts)
{
    return parts == 0 ? 0 : 5 + 35 * parts;
}

// Counts those of light states: their weights, the palette that these make, and what see-through patches then add.
constexpr uint32_t state_words(uint32_t states, uint32_t see_through_patches)
{
    constexpr uint32_t kPalette = detail::format::state::kPaletteBytes / 4,
                       kGlass = detail::format::kSeeThroughBytes / 4;
    return states == 0 ? 0 : 2 * states + kPalette + (see_through_patches == 0 ? 0 : kGlass);
}

// Counts those of gloss: for each map its colours, and its texels as the frame's eye sees them; then for each vertex
// that has a view table where it lies in these.
constexpr uint32_t gloss_words(uint32_t maps, uint32_t viewed)
{
    return maps == 0 ? 0 : maps * (detail::kGlossColours + detail::kGlossDiscBytes / 4) + (viewed + 1) / 2;
}

constexpr uint32_t feature_words(const SurfaceField& field)
{
    return see_through_words(field.see_through_count) + part_words(field.part_count) +
           state_words(field.state_count, field.see_through_count) +
           gloss_words(gloss_count(field), field.viewed_count);
}

constexpr uint32_t surface_links(uint32_t patches)
{
    return 2 * patches + (2 * patches + 3) / 4;
}

constexpr uint32_t surface_bands(int32_t height_px, uint32_t band_log2)
{
    return ((static_cast<uint32_t>(height_px) >> band_log2) + 1) * detail::kBandLists + 1;
}

// Returns the band of SurfaceMemory for stripes so many scanlines high: the largest that is no higher. Where stripes do
// not begin with bands of 16 or more, half of it: so few triangles are offered to a stripe that they do not reach.
// Lower stripes share bands of 16: of lower bands many triangles would reach more than a list can tell, and those are
// offered to every stripe.
constexpr uint32_t surface_band_log2(int32_t stripe_height_px)
{
    constexpr uint32_t kLeast = 4;
    if (stripe_height_px < 1 << kLeast) return kLeast;
    uint32_t log2 = kLeast;
    while (log2 < 8 && (2 << log2) <= stripe_height_px) ++log2;
    const bool begins_bands = (stripe_height_px & ((1 << log2) - 1)) == 0;
    return begins_bands ? log2 : log2 - 1;
}

// Counts the bytes that a frame needs besides sizeof(SurfaceFrame).
constexpr uint32_t surface_frame_bytes(uint32_t vertices, uint32_t patches, int32_t height_px, uint32_t band_log2)
{
    return vertices * static_cast<uint32_t>(sizeof(SurfaceVertex)) +
           static_cast<uint32_t>(sizeof(uint16_t)) * (surface_links(patches) + surface_bands(height_px, band_log2));
}

struct SurfaceFrame {
    SurfaceField field;
    SurfaceMemory memory;
    detail::SurfaceProjection projection;
    int32_t width_px, height_px;
    SurfaceMode mode;
    uint16_t see_through_triangles;     // of the order in `memory`: src/surface/order.h
    uint32_t samples_log2;              // a side of a pixel: 0 or 1
    int32_t margin;                     // samples around a stripe that it reads: 1 with outlines, else 0
    detail::Extent columns, scanlines;  // beside them all is background
    bool samples_are_pixels;            // in modes of one sample: detail/target.h
    bool is_whole;                      // no vertex is missing; where parts move, none of the body
    bool is_narrow;                     // areas of triangles fit 32 bits, of those that were listed last
    int32_t reach;                      // bands that a triangle of theirs reaches beyond its first, at most
    uint32_t other_list;                // the last of the bands' lists: triangles that are cut, large or tall
    detail::PackedColour palette[256];
};

}  // namespace lumi

namespace lumi::detail
{

void prepare(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode, const SurfaceMemory& memory,
             SurfaceFrame& out);
// Does that for a field without view tables: nothing that reads them is linked.
void prepare_without_views(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode,
                           const SurfaceMemory& memory, SurfaceFrame& out);
// After that it finds which triangles of these patches have a side on an outline.
void put_outlines(const SurfaceFrame& frame, uint32_t begin, uint32_t end);
// After that it lists the see-through triangles that face the eye, in the field's order, and lights them.
void put_see_through(SurfaceFrame& frame);

// After all triangles were listed it lights what the file's view tables have not, by the weights of states.
void put_states(const SurfaceFrame& frame);
// Does so for every other vertex of the body.
void put_states_of_half(const SurfaceFrame& frame, uint32_t half);

// After all triangles were listed it makes the discs of gloss maps for the eye, and places lit vertices in them.
void put_gloss(const SurfaceFrame& frame);

// Parts may move if there is memory for them; else they rest.
inline bool may_move(const SurfaceField& field, const SurfaceMemory& memory)
{
    return field.part_count != 0 && memory.features != nullptr;
}

// Tells how a frame whose parts may move begins. The body is kept where its vertices, lists and light are those of the
// frame before, because eye and mode are.
enum class MovingStart : uint8_t { nothing_shows, new_body, kept_body };
MovingStart begin_moving(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode,
                         const SurfaceMemory& memory, SurfaceFrame& out);
void put_body(SurfaceFrame& frame);
void put_parts(SurfaceFrame& frame, bool keeps_body);

struct PatchRange {
    uint32_t begin, end;
};
PatchRange patches_of_parts(const SurfaceFrame& frame);

// Returns the palette of see-through parts: 256 colours that are added, and 256 shares of what lies behind, which
// passes. They are PackedColour, but shares have no fraction for rounding.
inline PackedColour* see_through_palette(const SurfaceFrame& frame)
{
    return frame.memory.features + 2 * frame.field.see_through_count;
}

template <class Pixel>
void put_palette(SurfaceFrame& frame)
{
    frame.samples_are_pixels = kIsSample<Pixel> && frame.mode != SurfaceMode::two_by_two;
    const uint8_t* entry = frame.field.palette;
    for (PackedColour& c : frame.palette) {
        c = palette_colour<Pixel>({entry[0], entry[1], entry[2]});
        if (frame.mode == SurfaceMode::antialiased) c = mean_of(c, 0);
        entry += 3;
    }
}

// The colour behind brings its share of the rounding that palette_colour() adds, so what is added brings the rest.
template <class Pixel>
void put_see_through_palette(SurfaceFrame& frame)
{
    constexpr PackedColour kBlack = palette_colour<Pixel>({0, 0, 0});
    const bool has_halves = frame.mode == SurfaceMode::antialiased;
    const uint8_t* entry = frame.field.see_through + format::see_through::kPaletteAt;
    PackedColour* const palette = see_through_palette(frame);
    for (uint32_t k = 0; k < format::kPaletteEntries; ++k, entry += format::see_through::kEntryBytes) {
        const PackedColour passed = packed_shares(entry + 3);
        const PackedColour added = palette_colour<Pixel>({entry[0], entry[1], entry[2]}) - share_of(passed, kBlack);
        palette[k] = has_halves ? mean_of(added, 0) : added;
        palette[k + format::kPaletteEntries] = has_halves ? mean_of(passed, 0) : passed;
    }
}

// Fills the palettes, and does what kFeatures names: lists see-through parts, weighs states, puts gloss. Opaque
// triangles have been prepared.
template <class Pixel, SurfaceFeatures kFeatures>
void end_frame(SurfaceFrame& frame)
{
    put_palette<Pixel>(frame);
    if constexpr (has(kFeatures, SurfaceFeatures::see_through)) {
        put_see_through(frame);
        if (frame.field.see_through_count != 0) put_see_through_palette<Pixel>(frame);
    }
    if constexpr (has(kFeatures, SurfaceFeatures::states)) put_states(frame);
    if constexpr (has(kFeatures, SurfaceFeatures::gloss)) put_gloss(frame);
}

// `make_body` places the body, lists it, and finds its outlines.
template <class Pixel, SurfaceMode kFinest, SurfaceFeatures kFeatures, class MakeBody>
void prepare_moving(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode,
                    const SurfaceMemory& memory, SurfaceFrame& out, const MakeBody& make_body)
{
    const MovingStart start = begin_moving(field, camera, mode, memory, out);
    const bool keeps_body = start == MovingStart::kept_body;
    if (start != MovingStart::nothing_shows) {
        if (!keeps_body) make_body();
        put_parts(out, keeps_body);
        const PatchRange patches = patches_of_parts(out);
        if constexpr (kFinest != SurfaceMode::one_sample)
            if (out.margin != 0) put_outlines(out, patches.begin, patches.end);
    }
    if (!keeps_body) return end_frame<Pixel, kFeatures>(out);
    if constexpr (has(kFeatures, SurfaceFeatures::see_through))
        if (mover_count(field) != field.part_count) put_see_through(out);  // shadows have moved
    if constexpr (has(kFeatures, SurfaceFeatures::states)) put_states(out);
}

}  // namespace lumi::detail

namespace lumi
{

// Any field that open_surface accepted and any camera are safe. What vertices, lists and view tables cost:
// docs/log/speed.md.
// The mode is at most kFinest: what finer modes take is not linked, nor what parts take that kFeatures does not name
// and that fields do not have. See-through and moving parts come with view tables.
template <class Pixel, SurfaceMode kFinest = SurfaceMode::two_by_two,
          SurfaceFeatures kFeatures = SurfaceFeatures::view_tables>
void prepare_surface(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode,
                     const SurfaceMemory& memory, SurfaceFrame& out)
{
    if constexpr (has(kFeatures, SurfaceFeatures::parts)) {
        if (detail::may_move(field, memory))
            return detail::prepare_moving<Pixel, kFinest, kFeatures>(
                field, camera, mode, memory, out,
                [&] {
                    detail::put_body(out);
                    if constexpr (kFinest != SurfaceMode::one_sample)
                        if (out.margin != 0) detail::put_outlines(out, 0, detail::patches_of_parts(out).begin);
                });
    }
    if constexpr (kFeatures != SurfaceFeatures::none)
        detail::prepare(field, camera, mode, memory, out);
    else
        detail::prepare_without_views(field, camera, mode, memory, out);
    if constexpr (kFinest != SurfaceMode::one_sample)
        if (out.margin != 0) detail::put_outlines(out, 0, field.patch_count);
    detail::end_frame<Pixel, kFeatures>(out);
}

}  // namespace lumi
