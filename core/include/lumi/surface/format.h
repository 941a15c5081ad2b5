// SPDX-License-Identifier: MIT
// Byte layout of a surface field: radiance kept where rays meet the surface of the scene, a mesh in the unit sphere.
//
// A surface file has the container of field_format.h and a kSurfaceSection in place of layout and texels, so a reader
// that knows chord fields alone refuses it by name. Little-endian. Offsets below are within the section.
//
// The colour of the point u of a triangle, seen along a ray from direction ω:
//   texel(u) + Σ over corners c: b_c(u) · gain_c · Σ over view nodes k around ω: w_k · colour[k][code(c, k)]
// with b_c barycentric, and a gain for each channel. View nodes are points 0 .. kViewNodes - 1 of the Spherical
// Fibonacci lattice of kViewLattice points, in a frame of the vertex's own whose +z is about its normal; view_nodes.h
// finds those around a direction.
#pragma once
#pragma GCC system_header

#include "lumi/field_format.h"

namespace lumi::detail::format
{

inline constexpr uint32_t kSurfaceBytes = 32;
namespace surface
{
inline constexpr uint32_t kVerticesAt = 0;  // u16, 3 .. kMaxSurfaceVertices
inline constexpr uint32_t kViewedAt = 2;    // u16, vertices 0 .. this - 1 have a view table; 0: no kViewSection
inline constexpr uint32_t kPatchesAt = 4;   // u16, 1 .. kMaxPatches
// u16, below the number of patches: the last so many only darken what lies behind, so a reader that has no see-through
// patches leaves them out, and kSeeThroughSection is optional. 0: it is required, or there are none.
inline constexpr uint32_t kShadowsAt = 6;
inline constexpr uint32_t kTexelsAt = 8;        // u32, length of the texel section, 1 .. kMaxSurfaceTexels
inline constexpr uint32_t kColourSpaceAt = 12;  // u8, ColourSpace
inline constexpr uint32_t kLongestEdgeAt = 13;  // u8, of any triangle, steps of 1/64 radius, rounded up, 1 .. 128
inline constexpr uint32_t kCodeBitsAt = 14;     // u8, bits of a code in view tables, 1 .. kMaxCodeBits; without any: 0
inline constexpr uint32_t kReservedAt = 15;     // u8, 0
inline constexpr uint32_t kCentreAt = 16;       // 3 × IEEE binary32: the sphere's centre, scene units and axes
inline constexpr uint32_t kRadiusAt = 28;       // IEEE binary32 > 0
}  // namespace surface

inline constexpr uint32_t kMaxSurfaceVertices = 8192;
inline constexpr uint32_t kMaxPatches = 4096;
inline constexpr uint32_t kMaxSurfaceTexels = uint32_t{1} << 20;

// Vertices: x, y, z as s16, Q14, in the frame of the unit sphere; each within [-1, 1], and no vertex farther than
// 1 + 2^-12 from the centre.
inline constexpr uint32_t kVertexBytes = 6;

// A patch is a triangle (a, b, c), counter-clockwise seen from outside, and mostly a second one (d, c, b) beside it.
// Both share a rectangle of n × m texels, row after row: a lies in its corner (0, 0), b at (n, 0), c at (0, m), d at
// (n, m). Triangle 2p is patch p's first, 2p + 1 its second.
inline constexpr uint32_t kPatchBytes = 12;
namespace patch
{
inline constexpr uint32_t kCornersAt = 0;  // 4 × u16: a, b, c, d; d = kNoVertex: no second triangle
// u32: bits 0 .. 19 where the rectangle begins, 20 .. 25 n, 26 .. 31 m, both at least 1. The reader needs begin
// + 63·n + 63 to lie within the texel section, so that no texture coordinate, however wrong, leaves it.
inline constexpr uint32_t kTexelsAt = 8;
}  // namespace patch
inline constexpr uint32_t kNoVertex = 0xFFFF;
inline constexpr uint32_t kMaxPatchSide = 63;
// Texture coordinates keep so far inside a rectangle, in texels: corner a is at (1/4, 1/4), d at (n - 1/4, m - 1/4).
// A texel is found by rounding down.
inline constexpr uint32_t kPatchInsetShift = 2;
// Bytes from the beginning of a rectangle n wide that must lie within the texel section.
constexpr uint32_t patch_reach(uint32_t n)
{
    return kMaxPatchSide * n + kMaxPatchSide + 1;
}

// Neighbours: for each patch the triangles across its sides a-b, c-a, and c-d, d-b, or b-c where it has one triangle
// (then 0xFFFF). u16, of which kNeighbourMask is the triangle, or kNoNeighbour where the mesh ends. kCrease says that
// colours differ along the side; one of the two that share it has it, and where there is no neighbour it says nothing.
// With neighbours, outlines and creases can be drawn smooth (SurfaceMode).
inline constexpr uint32_t kNeighbourBytes = 8;
inline constexpr uint32_t kNeighbourMask = 0x7FFF, kCrease = 0x8000;
inline constexpr uint32_t kNoNeighbour = kNeighbourMask;

// See-through parts: the last patches, from kFirstAt on. Their texels name entries of the section's own palette: what
// the surface adds, multiplied by its coverage, and how much of what lies behind passes, 0 .. 255, for each channel. A
// pixel becomes added + passed · behind / 255.
//
// In which order they are drawn: from far to near by the depth of their nearest corner, or as they stand in the file,
// which is right where the writer found an order that suits all directions.
enum class DrawingOrder : uint8_t { by_depth = 0, of_the_file = 1 };
inline constexpr uint32_t kDrawingOrders = 2;
namespace see_through
{
inline constexpr uint32_t kFirstAt = 0;    // u16, number of the first see-through patch, below the number of patches
inline constexpr uint32_t kOrderAt = 2;    // u16, DrawingOrder
inline constexpr uint32_t kPaletteAt = 4;  // 256 × (r, g, b added, r, g, b passed)
inline constexpr uint32_t kEntryBytes = 6;
}  // namespace see_through
inline constexpr uint32_t kSeeThroughBytes = see_through::kPaletteAt + kPaletteEntries * see_through::kEntryBytes;

// Parts that move: rigid and opaque, each turns about an axis or slides along it. The section holds their number (u16,
// 1 .. kMaxParts), 0 (u16), and a record for each. The file has the body first, then part after part, in each of three
// ranges: vertices with view tables, those without, and opaque patches. So a part has the numbers from its own first
// ones up to those of the next part, and the last part up to the range's end. A part has a patch at least. Its patches
// have corners among its own vertices and neighbours among its own patches. At the value 0 vertices are where the file
// has them.
//
// The last records may be shadows. A shadow follows an earlier part: it has that part's value and kind of motion, but
// an axis of its own, no name, no opaque patch and no vertex with a view table. See-through patches are the body's, or
// a shadow's if their corners are all among its vertices.
inline constexpr uint32_t kMaxParts = 16;
inline constexpr uint32_t kPartsHeaderBytes = 4;
inline constexpr uint32_t kPartBytes = 80;

// A part that turns below its light has view tables for the eye that does not turn with it.
enum class Motion : uint8_t { turn = 0, slide = 1, turn_below_light = 2 };
inline constexpr uint32_t kMotions = 3;
namespace part
{
inline constexpr uint32_t kFirstViewedAt = 0;  // u16, <= kViewedAt's number
inline constexpr uint32_t kFirstPlainAt = 2;   // u16, from there on up to kVerticesAt's
inline constexpr uint32_t kFirstPatchAt = 4;   // u16
inline constexpr uint32_t kMotionAt = 6;       // u8, Motion
inline constexpr uint32_t kFollowsAt = 7;      // u8, 0: it moves by itself; k: it is a shadow of part k - 1
inline constexpr uint32_t kAxisAt = 8;         // 3 × s32, Q30, of unit length within 2^-12
inline constexpr uint32_t kPivotAt = 20;       // 3 × s32, Q20, a point of the axis, each within 2 radii; slides: 0
// s32, the least value, and u32, how far the greatest lies above it. Turns, right-handed about the axis: turns times
// 2^32, which wrap. Slides: radii, Q20, both ends within 2 radii.
inline constexpr uint32_t kFromAt = 32;
inline constexpr uint32_t kSpanAt = 36;
inline constexpr uint32_t kNameAt = 40;  // UTF-8, not empty, zeros behind it
inline constexpr uint32_t kNameBytes = 40;
}  // namespace part

// Light states: groups of lights whose weights a device chooses. Readers that do not know the section draw what the
// field's palettes and view tables say, which is their default weights. It holds the number of states, which are tints,
// a record for each state, and then for each state in turn what the surface shows under it alone:
//   palettes, 256 × (r, g, b); where the file has see-through parts, what these add, 256 × (r, g, b); where it has view
//   tables, node colours as theirs. Then for each vertex with a table a byte, which entry of the palette is its mean,
//   and its gains for each state.
// All are encoded after a division by the state's scale: linear light is scale/16 · decode(entry). Codes and turns are
// those of the view tables.
inline constexpr uint32_t kMinStates = 2, kMaxStates = 4;
// The number, u8; bits of those that are the base colour of a material, u8; zeros, u16.
inline constexpr uint32_t kStatesHeaderBytes = 4;
inline constexpr uint32_t kStateBytes = 32;
namespace state
{
inline constexpr uint32_t kNameAt = 0;  // UTF-8, not empty, zeros behind it
inline constexpr uint32_t kNameBytes = 28;
inline constexpr uint32_t kScaleAt = 28;    // u8, Q4, kOneQ4 .. 255
inline constexpr uint32_t kDefaultAt = 29;  // of r, g, b: 255 less the level of the default weight, u8; 0: full weight
inline constexpr uint32_t kOneQ4 = 16;
inline constexpr uint32_t kEntryBytes = 3;
inline constexpr uint32_t kPaletteBytes = kPaletteEntries * kEntryBytes;
}  // namespace state
constexpr uint32_t states_palettes_at(uint32_t count)
{
    return kStatesHeaderBytes + count * kStateBytes;
}
constexpr uint32_t states_see_through_at(uint32_t count)
{
    return states_palettes_at(count) + count * state::kPaletteBytes;
}
constexpr uint32_t states_views_at(uint32_t count, bool has_see_through)
{
    return states_see_through_at(count) + (has_see_through ? count * state::kPaletteBytes : 0);
}

// Gloss: what smooth surfaces mirror, as maps over mirrored directions. The number of maps, u8, 1 .. kMaxGlossMaps, and
// three zeros; for each map its gains of r, g and b, u8, and a zero; the maps; then two bits for each patch of the
// file, the first in the lowest bits: 0, or the number of its map from 1 on. See-through patches have none. All corners
// of a patch that has one have view tables, whose turns are its normals, at most 128/127 long. Moving parts have none;
// files with states have no such section.
//
// A map has kGlossSide × kGlossSide texels of a byte over the octahedral map of directions d, in the sphere's frame: at
// (x, y) of d/(|x| + |y| + |z|), and for z < 0 beyond the diamond's sides. Around them lies a border of one texel,
// which repeats what lies across: -1 - i, mirrored along the side. It adds gain/64 · texel, in 8-bit levels, to the
// colour that texel and tables make, which is clamped first. Between texels maps are bilinear.
//
// The mirrored direction is that of half vectors (gloss.h), which are interpolated between the corners.
inline constexpr uint32_t kMaxGlossMaps = 3;
inline constexpr uint32_t kGlossSide = 32, kGlossStride = kGlossSide + 2;
inline constexpr uint32_t kGlossMapBytes = kGlossStride * kGlossStride;
inline constexpr uint32_t kGlossHeaderBytes = 4, kGlossGainBytes = 4;
constexpr uint32_t gloss_maps_at(uint32_t maps)
{
    return kGlossHeaderBytes + maps * kGlossGainBytes;
}
constexpr uint32_t gloss_choices_at(uint32_t maps)
{
    return gloss_maps_at(maps) + maps * kGlossMapBytes;
}
constexpr uint32_t gloss_bytes(uint32_t maps, uint32_t patches)
{
    return gloss_choices_at(maps) + (patches + 3) / 4;
}

// View tables: colours of nodes, 2^bits each, then a record for each vertex that has a table. In a record the code of
// node k, which of its colours the node has, is bits k·bits .. (k + 1)·bits - 1 from the lowest bit of byte 0 on.
// Behind the codes lie kTurnBytes and kGainBytes.
inline constexpr uint32_t kViewLattice = 66;
inline constexpr uint32_t kViewNodes = 40;  // down to z = -0.2
inline constexpr uint32_t kMaxCodeBits = 8;
inline constexpr uint32_t kNodeColourBytes = 3;  // r, g, b as s8, in 8-bit levels times gain/64
inline constexpr uint32_t kTurnBytes = 3;  // the frame: half a turn about h takes +z to the vertex's; s8, h · 127
inline constexpr uint32_t kGainBytes = 3;  // u8 of r, g, b
constexpr uint32_t view_colours_bytes(uint32_t bits)
{
    return (kViewNodes << bits) * kNodeColourBytes;
}
// Where the turn lies in a record, and how long the record is.
constexpr uint32_t view_turn_at(uint32_t bits)
{
    return kViewNodes * bits / 8;
}
constexpr uint32_t view_bytes(uint32_t bits)
{
    return view_turn_at(bits) + kTurnBytes + kGainBytes;
}

// The section of states has for a vertex so many bytes, and in all of them so many.
constexpr uint32_t state_view_bytes(uint32_t count)
{
    return 1 + count * kGainBytes;
}
constexpr uint32_t states_bytes(uint32_t count, bool has_see_through, uint32_t viewed, uint32_t bits)
{
    const uint32_t views = viewed == 0 ? 0 : count * view_colours_bytes(bits) + viewed * state_view_bytes(count);
    return states_views_at(count, has_see_through) + views;
}

}  // namespace lumi::detail::format
