// SPDX-License-Identifier: MIT
// A guided field's surface seen by a camera: the proxy mesh's vertices on the image's grid of samples, its visible
// triangles in lists by bands of rows. Made once a frame, read by every stripe's ProxySurface (proxy_surface.h), also
// from several cores at once.
//
//     GuidedCamera camera; make_guided_camera(pose, {240, 240, fov}, camera);
//     ProxyFrame frame;    prepare_proxy(field.proxy, camera, 1, memory, frame);
//
// Samples: 1 a pixel at its centre, or 4: a grid of 2×2 a pixel whose rows are shifted to x = 1/8, 5/8 and 3/8, 7/8,
// at y = 1/4 and 3/4. Lengths on that grid are in samples: 2 a pixel with 4 samples a pixel, else 1.
//
// Depth is measured along the camera's forward axis. The stripe's buffer holds b = kEmptyDepth, or a number from
// kFarDepth to kNearDepth that is affine in 1/depth and therefore in the image. The mesh's own depths make the range,
// so that 16 bits serve an eye close by and one at 2047 R.
#pragma once

#include "lumi/camera.h"
#include "lumi/guided/guided_field.h"

namespace lumi
{

// What a proxy needs of a camera besides the sphere's rays.
struct GuidedCamera {
    Camera camera;
    Vec3q30 right, up, forward;
    Vec3q20 eye;                       // along right, up and forward
    uint32_t focal_q12;                // pixels per unit of tangent, 0.28 .. 469,364
    int32_t centre_x_q8, centre_y_q8;  // where the optical axis meets the image, pixels
};

// Fills `out`, which stays untouched on failure.
CameraError make_guided_camera(const Pose& pose, const Image& image, GuidedCamera& out);

inline constexpr uint32_t kEmptyDepth = 0;
inline constexpr uint32_t kFarDepth = 4096;    // so far from empty that depths of one surface never look like it
inline constexpr uint32_t kNearDepth = 65279;  // rounding on the way never wraps 16 bits
inline constexpr uint32_t kDepthSteps = 257;

// Surfaces nearer to the eye's plane than this are cut away: 1/256 R.
inline constexpr int32_t kNearPlaneShift = 8;

// A vertex on the sample grid: x and y in 1/64 sample, 24 bits each, and 16 bits of inverse depth, 0 for one that
// lies behind the near plane or beside the guard band.
struct ProxyVertex {
    int32_t x, y;
};

// The caller's memory for a frame; sizes below.
struct ProxyMemory {
    ProxyVertex* vertices;  // of every vertex; null: every use transforms it again, half as fast and 8 bytes less each
    uint16_t* links;        // of every triangle
    uint16_t* bands;        // proxy_bands()
    uint32_t band_log2;     // rows a band: best the rows of a stripe, 2^0 .. 2^8
};

// Triangles are listed by the band of rows in which they begin, on the finest level on which they reach over at most
// kBandReach bands; a level's bands are 4 times as high as the one's before. What must be clipped has a list of its
// own.
inline constexpr uint32_t kBandLevels = 5;
inline constexpr uint32_t kBandLevelLog2 = 2;
inline constexpr int32_t kBandReach = 4;

// Bands of one level, and of all.
constexpr uint32_t proxy_bands_of_level(int32_t height_px, uint32_t level_log2)
{
    return (static_cast<uint32_t>(height_px) + (uint32_t{1} << level_log2) - 1) >> level_log2;
}
constexpr uint32_t proxy_bands(int32_t height_px, uint32_t band_log2)
{
    uint32_t bands = 1;
    for (uint32_t level = 0; level < kBandLevels; ++level) {
        bands += proxy_bands_of_level(height_px, band_log2 + kBandLevelLog2 * level);
    }
    return bands;
}

// Bytes that a frame needs besides sizeof(ProxyFrame).
constexpr uint32_t proxy_frame_bytes(uint32_t vertices, uint32_t triangles, int32_t height_px, uint32_t band_log2,
                                     bool stores_vertices)
{
    return (stores_vertices ? vertices * static_cast<uint32_t>(sizeof(ProxyVertex)) : 0) +
           static_cast<uint32_t>(sizeof(uint16_t)) * (triangles + proxy_bands(height_px, band_log2));
}

// From a vertex's numbers to the sample grid; shifts and scales are chosen so that all fits 32 bits.
// docs/log/formats.md states ranges.
struct ProxyProjection {
    int32_t axis[3][3];   // rows x, y, z: per unit of a vertex's number
    int32_t base[3];      // what the numbers' offset of 2048 takes off
    int32_t shift[3];     // right, after the sum
    int32_t eye[3];       // added after the shift
    int32_t place_shift;  // of x and y after the division
    int32_t centre_x_q6, centre_y_q6;
    int32_t near_z, far_z;  // of the depth range, as z
    int32_t far_sum;        // of the depth range, as the sum before the shift
    int32_t ahead_shift;    // of far_sum - sum, to 16 bits
    uint32_t depth_factor;  // 16 bits
    int32_t depth_shift;
    int32_t depth_bits, place_bits;  // fraction bits of z, of x and y before the division
};

// From a depth in the buffer back to a length: how far before the far end of the range.
struct ProxyDepths {
    uint16_t exact_below;   // where linear interpolation would err by more than 2^-13
    uint16_t same_surface;  // depths that differ by no more are never farther apart than kSameSurface
    uint32_t offset;        // ((b - kFarDepth) << scale) + offset is proportional to 1/depth
    int32_t scale;
    uint32_t factor;  // 16 bits
    int32_t shift;
    uint16_t back_q13[kDepthSteps];  // at b = 256·k
};

// Depths of a pixel's samples closer than this are one surface: 0.03 R.
inline constexpr int32_t kSameSurfaceQ13 = 246;

// Pixels to points, see ProxyRow in proxy_surface.h: what every pixel needs, and what rows do.
struct ProxyRays {
    int32_t tangent_q26, tangent_step_q26;  // at pixel 0 and per pixel to the right
    int32_t across_q26, across_step_q26;    // the far end's place along the right axis
    int32_t right_q13[3];
};
struct ProxyRowRays {
    int32_t down_q26, down_step_q26;  // tangent at row 0 and per pixel downwards
    int32_t lift_q26, lift_step_q26;  // the far end's place along the up axis
    int32_t far_q26;                  // and along the forward axis
    Vec3q30 up, forward;
    int32_t up_q13[3];
};

// What a pixel reads comes first: offsets up to 124 are free on Cortex-M0+.
struct ProxyFrame {
    ProxyMesh mesh;
    ProxyRays rays;
    ProxyDepths depths;
    ProxyRowRays row_rays;
    ProxyMemory memory;
    ProxyProjection projection;
    int32_t width_px, height_px;
    uint32_t samples_log2;  // a side of a pixel: 0 or 1
    uint32_t clipped_band;  // the last of all: triangles that are cut or large
    bool narrow;            // areas of the mesh's triangles fit 32 bits
};

// Prepares a frame of `samples` 1 or 4 a pixel. memory.* belongs to the frame as long as it is used; the mesh's bytes,
// too. About 170 instructions a vertex and 100 a triangle on Cortex-M4, several hundred more for one that the near
// plane or a guard band around the image cuts. Any mesh that open_guided accepted is safe.
void prepare_proxy(const ProxyMesh& mesh, const GuidedCamera& camera, uint32_t samples, const ProxyMemory& memory,
                   ProxyFrame& out);

}  // namespace lumi
