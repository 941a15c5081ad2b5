// SPDX-License-Identifier: MIT
// Work of drawing, counted where it is done. A tool that tells what frames cost compiles core once more, in a namespace
// of its own, with LUMI_COUNT_WORK. In every other build nothing is left of it, and no instruction differs.
#pragma once

#include <stdint.h>

namespace lumi::detail
{

enum class Work : uint8_t {
    background,  // pixels beside the field, and beside what covers them
    // Surface fields, a frame.
    frame,
    vertex,
    patch,
    listed,        // triangles that face the eye
    lit,           // vertices that have view tables, of these
    bordered,      // patches whose outlines are looked for
    see_triangle,  // see-through ones of the field
    ordered,       // those of them that show
    // A stripe.
    stripe,
    word,        // words that are cleared or copied
    see_word,    // samples whose colours are filled beforehand
    link,        // steps along lists
    offered,     // triangles
    boxed,       // those whose boxes have samples
    looked_at,   // samples that are compared to know whether all of a box are hidden
    begun,       // triangles and parts whose rows are set up
    wide,        // parts of wide triangles, and looks whether one is
    split,       // parts of large triangles that are looked at
    split_part,  // those that are drawn
    row,
    filled,  // rows that have samples
    // Samples of loops, each with those that are nearer than what was there.
    sample,
    shown,
    two_taps_sample,
    two_taps_shown,
    packed_sample,
    packed_shown,
    bilinear_sample,
    bilinear_shown,
    see_sample,
    see_shown,
    see_two_taps_sample,
    see_two_taps_shown,
    see_bilinear_sample,
    see_bilinear_shown,
    mixed_texels,  // of four that differ
    clamped,       // samples brighter than white or darker than black
    see_alone,     // samples that blend over the background
    outline,       // triangles with outlines
    edge,          // their outlines
    line,          // lines of samples that these cross
    marked,        // pixels that they cut
    four,          // pixels of four samples
    four_whole,    // those that are covered
    four_apart,    // those of these whose light is averaged
    four_mixed,    // those that are covered in part
    gloss_vertex,  // places in the discs of gloss
    gloss_texel,   // texels of the discs
    gloss_begun,   // triangles and parts that have gloss
    gloss_shown,   // samples of these that are nearer than what was there
    // Chord fields by spans.
    gap,        // begins of spans that do not follow another one
    tile_side,  // tries, of one side
    span_side,
    zone,  // changes of a side's zone
    polar_side,
    piece,
    pixel,  // of Nearest, in the order of TexelFormat
    pixel_rgb565,
    pixel_palette8,
    pixel_luma8,
    linear_piece,
    linear_pixel,  // of Linear, likewise
    linear_pixel_rgb565,
    linear_pixel_palette8,
    linear_pixel_luma8,
    flipped_pixel,   // those of pieces with cells of either diagonal
    checked_pixel,   // of Nearest
    checked_linear,  // pixels of Linear that are drawn side by side
    checked_row,     // origins that these read
    // Exact pixels of chord fields.
    exact,
    zone_step,
    distance,  // points of cells
    scanned,   // points that are all looked at
    polar_triangle,
    hull_triangle,
    tap,  // texels
    kCount
};

// The work that is so many kinds behind the first one of a row of them.
constexpr Work nth_work(Work first, uint32_t n)
{
    return static_cast<Work>(static_cast<uint32_t>(first) + n);
}

inline constexpr uint32_t kWorks = static_cast<uint32_t>(Work::kCount);

}  // namespace lumi::detail

// LUMI_TALLY(Work::edge, times): a macro, since GCC allots other registers where even an empty call has been.
#ifdef LUMI_COUNT_WORK
namespace lumi::detail
{
inline thread_local uint64_t work_done[kWorks] = {};
}
#define LUMI_TALLY(work, times) (::lumi::detail::work_done[static_cast<uint32_t>(work)] += static_cast<uint64_t>(times))
#else
#define LUMI_TALLY(work, times) static_cast<void>(0)
#endif
