// SPDX-License-Identifier: MIT
// Whole pictures of a guided field in double precision: rays against triangles one by one in place of a rasterizer,
// exact origin weights, light mixed without tables. Under a second for 240 × 240 pixels with 4 samples each.
#pragma once

#include <vector>

#include "lumi/reference/guided_shading.h"

namespace lumi::reference
{

// Samples of a pixel: its centre, or the rotated grid of four.
struct GuidedDrawing {
    bool antialiased = true;
    GuidedShading shading;
};

// Row by row from the top; encoded values 0 .. 255 over the background, and the share of each pixel that is covered.
struct GuidedPicture {
    int32_t width_px = 0, height_px = 0;
    std::vector<Colour> colours;
    std::vector<double> coverage;
};

// Precondition: make_camera accepts pose and image.
GuidedPicture draw_guided(const GuidedField& field, const Pose& pose, const Image& image, const GuidedDrawing& drawing,
                          const Rgb8& background);

// Samples of one pixel whose depths, along the viewing axis, differ by less than this many radii see one surface: it is
// shaded once, at the mean of their points.
inline constexpr double kSameSurface = 0.03;

// What a sample of the proxy sees.
struct ProxyHit {
    bool hit = false;
    double depth = 0;  // along the viewing axis
    Vec3 x = {0, 0, 0};
};

// Of every pixel's samples, pixel by pixel: 4 a pixel if antialiased, else 1. The proxy's nearest triangle in front of
// the eye, seen from its outside unless it is two-sided.
std::vector<ProxyHit> proxy_hits(const ProxyMesh& proxy, const Pose& pose, const Image& image, bool antialiased);

}  // namespace lumi::reference
