// SPDX-License-Identifier: MIT
// Byte layout of the sections of a guided field: a field whose rays are aimed through a shared surface.
//
// A guided file has the container of field_format.h and a kGuidedSection in place of layout and texels, so a reader
// that knows chord fields alone refuses it by name. Every other section is there only if the scene needs it.
// docs/field-format.md lists the sections. Little-endian. Offsets below are within the section.
//
// Reconstruction of a pixel that sees the surface at X (unit sphere's frame), its ray entering the sphere at h:
//   origins k = 0..2 with weights w_k: the origin lattice's triangle around h (lattice.h);
//   chart_k:  e = X - p_k, the grid point (u, v) of e in origin k's chart, see below;
//   taps t:   the grid triangle around (u, v), or its heaviest corner;
//   weight    w = w_k · w_t, 0 where the texel is missing or X is hidden from p_k (occlusion section);
//   value     Σ w·palette[texel] / W with W = Σ w. With a mean section it is a difference that is added to the mean at
//             X, and it fades to 0 as Σ w·palette / max(W, 1/4). Without one it is the colour itself; without one and
//             on a focus surface W is the pixel's coverage.
#pragma once

#include "lumi/field_format.h"

namespace lumi::format
{

inline constexpr uint32_t kGuidedSection = four_cc('G', 'U', 'I', 'D');     // required, kGuidedBytes
inline constexpr uint32_t kProxySection = four_cc('P', 'R', 'O', 'X');      // required with GuidedSurface::proxy
inline constexpr uint32_t kMeanSection = four_cc('M', 'E', 'A', 'N');       // optional: view-averaged colour in voxels
inline constexpr uint32_t kChartSection = four_cc('C', 'H', 'R', 'T');      // required unless GuidedTexel::none
inline constexpr uint32_t kChartColours = four_cc('C', 'P', 'A', 'L');      // required with kChartSection
inline constexpr uint32_t kOcclusionSection = four_cc('O', 'C', 'C', 'L');  // optional, with a proxy only

enum class GuidedSurface : uint8_t {
    proxy = 0,  // a triangle mesh; pixels beside it are background
    focus = 1,  // the point of each ray nearest to a focus point, or where it enters a sphere around it
};
inline constexpr uint32_t kGuidedSurfaces = 2;

enum class GuidedTexel : uint8_t {
    none = 0,    // no chart: the mean alone
    index4 = 1,  // two texels a byte, the even one in the low bits; 16 colours a group of origins
    index8 = 2,  // a byte; 256 colours a group
    vq8 = 3,     // a byte for 2×2 grid points; 256 blocks of four colours a group
};
inline constexpr uint32_t kGuidedTexels = 4;
// Colours of a group of origins.
constexpr uint32_t chart_colours(GuidedTexel texel)
{
    return texel == GuidedTexel::index4 ? 16 : texel == GuidedTexel::vq8 ? 1024 : 256;
}

inline constexpr uint32_t kGuidedBytes = 44;
namespace guided
{
inline constexpr uint32_t kOriginsAt = 0;             // u32, M, kMinGuidedOrigins .. kMaxGuidedOrigins
inline constexpr uint32_t kUsedOriginsAt = 4;         // u32, 1 .. M: origins 0 .. used - 1
inline constexpr uint32_t kChartSizeAt = 8;           // u16, G: grid points across a chart, kMinChart .. kMaxChart
inline constexpr uint32_t kTexelAt = 10;              // u8, GuidedTexel
inline constexpr uint32_t kSurfaceAt = 11;            // u8, GuidedSurface
inline constexpr uint32_t kColourSpaceAt = 12;        // u8, ColourSpace
inline constexpr uint32_t kReservedAt = 13;           // u8, 0
inline constexpr uint32_t kOriginsPerPaletteAt = 14;  // u16, >= 1: origins o·this .. share the colours of group o
inline constexpr uint32_t kCentreAt = 16;             // 3 × IEEE binary32: the sphere's centre, scene units and axes
inline constexpr uint32_t kRadiusAt = 28;             // IEEE binary32 > 0
inline constexpr uint32_t kFocusAt = 32;              // 3 × s16, Q14, each in [-1, 1]: the focus point; 0 with a proxy
inline constexpr uint32_t kFocusRadiusAt = 38;        // u16, Q14, <= 1; 0: the nearest point of the ray; 0 with a proxy
inline constexpr uint32_t kReserved2At = 40;          // u32, 0
}  // namespace guided
inline constexpr uint32_t kMinGuidedOrigins = 64;  // below, the lattice has no zones to step through
inline constexpr uint32_t kMaxGuidedOrigins = 4096;
inline constexpr uint32_t kMinChart = 8;
inline constexpr uint32_t kMaxChart = 400;

// Proxy mesh: header, then vertices, then triangles, each a triple of 12-bit numbers; two triples fill nine bytes,
// number n of all in a block at bit 12·n, low bits first. The triangles' block starts at the next multiple of 4.
// A coordinate c stands for (c - 2048)/2048. A triangle's vertices run counter-clockwise seen from its outside.
namespace proxy
{
inline constexpr uint32_t kVerticesAt = 0;   // u16, 0 .. kMaxProxyVertices
inline constexpr uint32_t kTrianglesAt = 2;  // u16, 0 .. kMaxProxyTriangles; every index < vertices
inline constexpr uint32_t kFlagsAt = 4;      // u32, kTwoSided or 0
inline constexpr uint32_t kVertexBlockAt = 8;
}  // namespace proxy
inline constexpr uint32_t kTwoSided = 1;  // triangles are seen from both sides
inline constexpr uint32_t kMaxProxyVertices = 4096;
inline constexpr uint32_t kMaxProxyTriangles = 8192;
constexpr uint32_t triples_bytes(uint32_t count)
{
    return (count * 36 + 7) / 8;
}
constexpr uint32_t proxy_triangles_at(uint32_t vertices)
{
    return (proxy::kVertexBlockAt + triples_bytes(vertices) + 3) / 4 * 4;
}

// Mean colours at the nodes of a grid over the sphere's cube: node (i, j, k) lies at (2·i/resolution - 1, ...), and
// the colour at X is trilinear between the eight nodes around it. Nodes lie in bricks of 4×4×4, x fastest; a box of
// bricks is present, each by its number in the index (x fastest). A node outside the box is read as the nearest inside.
namespace mean
{
inline constexpr uint32_t kResolutionAt = 0;  // u16, kMinMean .. kMaxMean
inline constexpr uint32_t kFormatAt = 2;      // u8, MeanFormat
inline constexpr uint32_t kReservedAt = 3;    // u8, 0
inline constexpr uint32_t kFirstBrickAt = 4;  // 3 × u8: of the box, in bricks from node 0; first + count <= 64 each
inline constexpr uint32_t kReserved2At = 7;   // u8, 0
inline constexpr uint32_t kBoxAt = 8;         // 3 × u8 >= 1: bricks of the box along x, y, z
inline constexpr uint32_t kReserved3At = 11;  // u8, 0
inline constexpr uint32_t kBricksAt = 12;     // u16 >= 1: bricks present; every index entry is below it
inline constexpr uint32_t kReserved4At = 14;  // u16, 0
inline constexpr uint32_t kContentAt = 16;    // [palette8: 256 × (r, g, b, 0)], index of u16 padded to 4, bricks
}  // namespace mean
inline constexpr uint32_t kMinMean = 8;
inline constexpr uint32_t kMaxMean = 252;
inline constexpr uint32_t kBrickNodes = 64;
enum class MeanFormat : uint8_t { rgb565 = 0, palette8 = 1 };
inline constexpr uint32_t kMeanFormats = 2;

// A chart table: for every used origin the texels of its chart, stored row by row from the first grid point that the
// surface needs to the last. Header, directory, row table of u16 padded to 4, texels.
// Texel of grid point (u, v) of origin i: number texel_base + ((row[row_base + v - first_row] + u) mod 2^16).
// v outside the origin's rows, or a number beyond the texels: missing. With GuidedTexel::vq8 the same of blocks: grid
// point (u, v) lies in block (u >> 1, v >> 1), which has one number; texels, rows and first_row count blocks.
namespace chart
{
inline constexpr uint32_t kRowsAt = 0;    // u32: entries of the row table, of all origins together
inline constexpr uint32_t kTexelsAt = 4;  // u32: texels of all origins together
inline constexpr uint32_t kDirectoryAt = 8;
inline constexpr uint32_t kEntryBytes = 12;
inline constexpr uint32_t kTexelBaseAt = 0;  // u32 <= texels
inline constexpr uint32_t kRowBaseAt = 4;    // u32; row_base + row_count <= rows
inline constexpr uint32_t kFirstRowAt = 8;   // u16
inline constexpr uint32_t kRowCountAt = 10;  // u16
}  // namespace chart

// A chart maps the directions into the sphere at an origin point p to a triangular grid, uniform in the area of the
// sphere where those rays leave it. With the tangent frame (T, B) of p (guided_chart.h), a unit direction ê has the
// place a = T·ê, b = B·ê in a disc of radius 1, where equal areas stand for equal areas of the sphere. Grid points are
//   u = c + (a + b/√3)·G/2,  v = c + (2b/√3)·G/2,  c = chart_centre(G),
// whose steps form 120°: (0,0) (1,0) (1,1) are the corners of a triangle where frac u > frac v, else (0,0) (0,1) (1,1).
constexpr uint32_t chart_centre(uint32_t size)
{
    return (size * 37838u >> 16) + 3;  // G/√3 and a margin for taps
}

// Occlusion: a chart table of the grid points (u >> kOcclusionShift, v >> kOcclusionShift) with one byte each: X is
// hidden from the origin where |X - p| > byte/128. 255 hides nothing.
inline constexpr uint32_t kOcclusionShift = 3;

// Chart colours: groups of chart_colours() entries (r, g, b, 0), ceil(used_origins / origins_per_palette) groups. With
// a mean section r, g, b are differences, two's complement. Entry 0 of each group means a missing texel and is 0. With
// vq8, number c stands for the entries 4c + 2·(v mod 2) + (u mod 2) of grid points (u, v); 0 for four missing ones.
inline constexpr uint32_t kChartColourBytes = 4;

}  // namespace lumi::format
