// SPDX-License-Identifier: MIT
// Rasterized surfaces against rays through the mesh in double precision.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "lumi/reference/guided_picture.h"
#include "proxy/proxy_drawing.h"

namespace lumi::test
{

// What rays against triangles see, through every sample's place and through four places 1/16 of a pixel around it: the
// rasterizer rounds vertices to 1/64 of a sample and may answer for any ray in between.
inline constexpr int kPlaces = 5;
inline constexpr int32_t kPlaceQ8[kPlaces][2] = {{0, 0}, {16, 0}, {-16, 0}, {0, 16}, {0, -16}};

struct Truth {
    std::vector<reference::ProxyHit> hits[kPlaces];

    Truth(const ProxyMesh& mesh, const Pose& pose, const Image& image, bool antialiased)
    {
        for (int k = 0; k < kPlaces; ++k) {
            Image moved = image;
            moved.shift_x_q8 += kPlaceQ8[k][0];
            moved.shift_y_q8 += kPlaceQ8[k][1];
            hits[k] = reference::proxy_hits(mesh, pose, moved, antialiased);
        }
    }

    int hit_count(size_t sample) const
    {
        int count = 0;
        for (const auto& h : hits) count += h[sample].hit;
        return count;
    }
    // How far apart the places' points are.
    double spread(size_t sample) const
    {
        double widest = 0;
        for (const auto& h : hits) {
            if (!h[sample].hit) return 10;
            widest = std::max(widest, reference::length(h[sample].x - hits[0][sample].x));
        }
        return widest;
    }
};

// The step of a depth in the buffer, in radii at depth z, as docs/log/formats.md states it.
inline double depth_step(const ProxyMesh& mesh, const Pose& pose, double z)
{
    double nearest = 1e9, farthest = 1.0 / 256;
    for (uint32_t k = 0; k < mesh.vertex_count; ++k) {
        const Triple12 v = triple12(mesh.vertices, k);
        const Vec3 p = {(v.a - 2048) / 2048.0, (v.b - 2048) / 2048.0, (v.c - 2048) / 2048.0};
        const double depth = reference::dot(p - reference::decoded(pose.eye), reference::decoded(pose.forward));
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    nearest = std::max(nearest, 1.0 / 256);
    farthest = std::max(farthest, nearest + 0.5);
    return z * z * (1 / nearest - 1 / farthest) / (kNearDepth - kFarDepth);
}

// Vertices, edges, gradients and the buffer round depths: together at most this many steps. `place` is what the ray's
// own place explains.
inline double point_bound(const ProxyMesh& mesh, const Pose& pose, double depth, double place)
{
    constexpr double kStepsOff = 4;
    return 0.001 + kStepsOff * depth_step(mesh, pose, depth) + place;
}

inline Vec3 point_of(const SurfacePoint& p)
{
    return {p.x_q14 / 16384.0, p.y_q14 / 16384.0, p.z_q14 / 16384.0};
}

// Where a hit is nearer than the near plane, anything may be seen behind it.
inline bool is_cut(const reference::ProxyHit& hit)
{
    return hit.hit && hit.depth < 1.2 / 256;
}

struct Findings {
    int wrong_hits = 0, undecided = 0, seen = 0;
    double worst = 0;  // error beyond what the ray's place explains, in steps of the bound
    int32_t worst_x = 0, worst_y = 0;

    void see(double error, int32_t x, int32_t y)
    {
        if (error > worst) worst = error, worst_x = x, worst_y = y;
    }
};

// Draws the surface and lets `judge(findings, picture, x, y)` look at every pixel whose ray meets the sphere.
template <uint32_t Samples, class Judge>
Findings judge_surface(const ProxyMesh& mesh, const Pose& pose, const Image& image, Judge judge)
{
    const SurfacePicture picture = draw_surface<Samples>(mesh, pose, image);
    REQUIRE(picture.height_px == image.height_px);
    GuidedCamera camera;
    REQUIRE(make_guided_camera(pose, image, camera) == CameraError::none);
    Findings f;
    for (int32_t y = 0; y < image.height_px; ++y) {
        for (int32_t x = 0; x < image.width_px; ++x) {
            SphereRay ray;
            if (!ray_at(camera.camera, x, y, ray)) continue;
            ++f.seen;
            judge(f, picture, x, y);
        }
    }
    return f;
}

inline size_t pixel_index(const Image& image, int32_t x, int32_t y)
{
    return static_cast<size_t>(y) * static_cast<size_t>(image.width_px) + static_cast<size_t>(x);
}

inline Findings compare_centres(const ProxyMesh& mesh, const Pose& pose, const Image& image)
{
    const Truth truth(mesh, pose, image, false);
    const auto judge = [&](Findings& f, const SurfacePicture& picture, int32_t x, int32_t y) {
        const size_t k = pixel_index(image, x, y);
        const int hits = truth.hit_count(k);
        const reference::ProxyHit& centre = truth.hits[0][k];
        const auto& seen = picture.at(x, y);
        const double spread = truth.spread(k);
        if ((hits != 0 && hits != kPlaces) || is_cut(centre) || (hits != 0 && spread > 0.05)) {
            ++f.undecided;
            return;
        }
        if (seen.size() != (hits != 0 ? 1u : 0u)) ++f.wrong_hits;
        if (hits == 0 || seen.empty()) return;
        f.see(reference::length(point_of(seen[0]) - centre.x) / point_bound(mesh, pose, centre.depth, spread), x, y);
    };
    return judge_surface<1>(mesh, pose, image, judge);
}

// What the rays see through a pixel's four samples.
struct PixelTruth {
    uint32_t hits = 0;
    bool decided = true;
    double spread = 0;
    Vec3 mean = {0, 0, 0};

    PixelTruth(const Truth& truth, size_t first)
    {
        for (size_t k = first; k < first + 4; ++k) {
            const int places = truth.hit_count(k);
            decided = decided && (places == 0 || places == kPlaces) && !is_cut(truth.hits[0][k]);
            hits += places != 0;
            mean = mean + 0.25 * truth.hits[0][k].x;
            spread =
                std::max({spread, truth.spread(k), reference::length(truth.hits[0][k].x - truth.hits[0][first].x)});
        }
    }
};

// The same for four samples a pixel: how many see the surface, and X where one surface fills the pixel.
inline Findings compare_samples(const ProxyMesh& mesh, const Pose& pose, const Image& image)
{
    const Truth truth(mesh, pose, image, true);
    const auto judge = [&](Findings& f, const SurfacePicture& picture, int32_t x, int32_t y) {
        const size_t first = 4 * pixel_index(image, x, y);
        const PixelTruth expected(truth, first);
        if (!expected.decided) {
            ++f.undecided;
            return;
        }
        uint32_t found = 0;
        const auto& seen = picture.at(x, y);
        for (const SurfacePoint& p : seen) found += p.samples;
        if (found != expected.hits) ++f.wrong_hits;
        if (expected.hits != 4 || seen.size() != 1 || expected.spread > 0.02) return;
        const double bound = point_bound(mesh, pose, truth.hits[0][first].depth, 0.25 * expected.spread);
        f.see(reference::length(point_of(seen[0]) - expected.mean) / bound, x, y);
    };
    return judge_surface<4>(mesh, pose, image, judge);
}

inline void check(const Findings& f)
{
    INFO("seen " << f.seen << ", undecided " << f.undecided << ", worst at " << f.worst_x << ", " << f.worst_y);
    CHECK(f.wrong_hits == 0);
    CHECK(f.worst <= 1);
}

}  // namespace lumi::test
