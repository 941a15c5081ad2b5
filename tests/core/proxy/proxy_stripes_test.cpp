// SPDX-License-Identifier: MIT
// Surfaces beside each other, in stripes and within a pixel.
#include <catch2/catch.hpp>
#include <random>

#include "lumi/crc32.h"
#include "proxy/proxy_drawing.h"

using namespace lumi;
using namespace lumi::test;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr int32_t kSidePx = 10;
constexpr int kTurns = 1;
constexpr uint32_t kBallSteps = 6;
#else
constexpr int32_t kSidePx = 72;
constexpr int kTurns = 30;
constexpr uint32_t kBallSteps = 24;
#endif

// Of "the same bits"; a change of the arithmetic changes it, a processor must not.
constexpr uint32_t kCrcOnEveryProcessor = 0x3E29A8F4;

// A plate of jittered squares, cut along either diagonal.
TestMesh mosaic(std::mt19937& random, uint32_t side)
{
    TestMesh mesh;
    const auto place = [&](uint32_t k) {
        const int32_t jitter = k == 0 || k == side ? 0 : static_cast<int32_t>(random_below(random, 41)) - 20;
        return (k * 2.0 / side - 1) * 0.7 + jitter / 2048.0;
    };
    for (uint32_t y = 0; y <= side; ++y) {
        for (uint32_t x = 0; x <= side; ++x) {
            const double right = place(x), up = place(y);  // in this order with every compiler
            mesh.vertices.push_back(vertex_at(right, up, 0));
        }
    }
    for (uint32_t y = 0; y < side; ++y) {
        for (uint32_t x = 0; x < side; ++x) {
            const uint32_t a = y * (side + 1) + x, b = a + 1, c = a + side + 1, d = c + 1;
            if (random_below(random, 2) == 0) {
                mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {a, d, c}});
            } else {
                mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {b, d, c}});
            }
        }
    }
    return mesh;
}

}  // namespace

TEST_CASE("triangles that share an edge leave no gap", "[proxy]")
{
    std::mt19937 random(3);
    const PackedMesh mesh(mosaic(random, 16));
    for (int k = 0; k < kTurns; ++k) {
        const Pose pose = look_at({0.3, -0.2, 1.6}, {0.1, 0.1, 0}, k * 17.0);
        const Image image = {2 * kSidePx, 2 * kSidePx, degrees(10 + k % 14)};  // the plate fills the view
        const SurfacePicture single = draw_surface<1>(mesh.view, pose, image);
        const SurfacePicture quadruple = draw_surface<4>(mesh.view, pose, image);
        int gaps = 0;
        for (size_t p = 0; p < single.pixels.size(); ++p) {
            gaps += single.pixels[p].size() != 1;
            gaps += quadruple.pixels[p].size() != 1 || quadruple.pixels[p][0].samples != 4;
        }
        INFO("view " << k);
        CHECK(gaps == 0);
    }
}

namespace
{

bool same(const SurfacePicture& a, const SurfacePicture& b)
{
    if (a.height_px != b.height_px || a.pixels.size() != b.pixels.size()) return false;
    for (size_t k = 0; k < a.pixels.size(); ++k) {
        if (a.pixels[k].size() != b.pixels[k].size()) return false;
        for (size_t s = 0; s < a.pixels[k].size(); ++s) {
            const SurfacePoint &p = a.pixels[k][s], &q = b.pixels[k][s];
            if (p.x_q14 != q.x_q14 || p.y_q14 != q.y_q14 || p.z_q14 != q.z_q14 || p.samples != q.samples) return false;
        }
    }
    return true;
}

template <uint32_t Samples>
void check_cuts(const ProxyMesh& mesh, const Pose& pose, const Image& image)
{
    const SurfacePicture whole = draw_surface<Samples>(mesh, pose, image, {true, 4, 8192, 8192, false});
    for (const bool stores : {true, false}) {
#ifdef LUMI_TEST_LIGHT
        const std::vector<uint32_t> logs = {2};
#else
        const std::vector<uint32_t> logs = {0, 2, 4, 8};
#endif
        for (const uint32_t log2 : logs) {
            CHECK(same(whole, draw_surface<Samples>(mesh, pose, image, {stores, log2, 8192, 16, false})));
            CHECK(same(whole, draw_surface<Samples>(mesh, pose, image, {stores, log2, 13, 7, true})));
            CHECK(same(whole, draw_surface<Samples>(mesh, pose, image, {stores, log2, 8192, 1, true})));
        }
    }
}

}  // namespace

TEST_CASE("any cut of the image into stripes gives the same surfaces, with or without vertices in memory", "[proxy]")
{
    const PackedMesh wavy(ball(kBallSteps, kBallSteps, 0.8, 0.1)), flat(plate(0.9)), thin(needle());
    for (const PackedMesh* mesh : {&wavy, &flat, &thin}) {
        const Pose pose = look_at({1.2, -0.7, 0.6}, {0.1, 0, 0}, 33);
        check_cuts<1>(mesh->view, pose, {kSidePx + 5, kSidePx, degrees(50)});
        check_cuts<4>(mesh->view, pose, {kSidePx, kSidePx + 3, degrees(60)});
        check_cuts<4>(mesh->view, look_at({1.01, 0, 0.1}, {0, 0.8, 0.2}), {kSidePx, kSidePx, degrees(110)});
    }
}

TEST_CASE("a pixel tells its surfaces apart and where each of them is", "[proxy]")
{
    // A small plate above the left half of a larger one, its edge through the middle of a pixel column.
    TestMesh steps;
    steps.vertices = {vertex_at(-0.5, -0.5, 0), vertex_at(0.5, -0.5, 0),    vertex_at(0.5, 0.5, 0),
                      vertex_at(-0.5, 0.5, 0),  vertex_at(-0.5, -0.5, 0.5), vertex_at(0, -0.5, 0.5),
                      vertex_at(0, 0.5, 0.5),   vertex_at(-0.5, 0.5, 0.5)};
    steps.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
    const PackedMesh mesh(steps);
    const Pose above = {{0, 0, 3 * kOneQ20}, {kOneQ30, 0, 0}, {0, kOneQ30, 0}, {0, 0, -kOneQ30}};
    const SurfacePicture picture = draw_surface<4>(mesh.view, above, {17, 17, degrees(30)});
    const auto& pixel = picture.at(8, 8);
    REQUIRE(pixel.size() == 2);
    CHECK(pixel[0].samples == 2);
    CHECK(pixel[1].samples == 2);
    const SurfacePoint& upper = pixel[0].z_q14 > pixel[1].z_q14 ? pixel[0] : pixel[1];
    const SurfacePoint& lower = pixel[0].z_q14 > pixel[1].z_q14 ? pixel[1] : pixel[0];
    CHECK(std::abs(upper.z_q14 - 8192) < 8);
    CHECK(std::abs(lower.z_q14) < 8);
    // Samples at x = 1/8, 3/8 see the upper plate, 5/8, 7/8 the lower one: their means are a quarter off the centre.
    const double pixel_width = 2 * std::tan(15 * reference::kPi / 180) / 17;
    CHECK(upper.x_q14 / 16384.0 == Approx(-0.25 * pixel_width * 2.5).margin(0.001));
    CHECK(lower.x_q14 / 16384.0 == Approx(0.25 * pixel_width * 3).margin(0.001));
}

TEST_CASE("surfaces are the same bits on every processor", "[proxy]")
{
    // Meshes and cameras from integers alone; the boards run this very test (tests/cross).
    std::mt19937 random(5);
    const PackedMesh plates(mosaic(random, 8)), scraps(soup(random, 20));
    uint32_t crc = 0;
    const auto add = [&](const SurfacePicture& picture) {
        for (const auto& pixel : picture.pixels) {
            for (const SurfacePoint& p : pixel) {
                const int32_t numbers[] = {p.x_q14, p.y_q14, p.z_q14, static_cast<int32_t>(p.samples)};
                for (const int32_t n : numbers) {
                    const uint32_t u = static_cast<uint32_t>(n);
                    const uint8_t bytes[] = {static_cast<uint8_t>(u), static_cast<uint8_t>(u >> 8),
                                             static_cast<uint8_t>(u >> 16), static_cast<uint8_t>(u >> 24)};
                    crc = crc32(crc, bytes, sizeof bytes);
                }
            }
        }
    };
    for (const PackedMesh* mesh : {&plates, &scraps}) {
        for (const int32_t distance_q20 : {kOneQ20 + kOneQ20 / 100, 3 * kOneQ20, 900 * kOneQ20}) {
            const Pose pose = orbit(0x12345678u, 0x18000000, distance_q20);
            const Image image = {24, 20, distance_q20 > 100 * kOneQ20 ? kMinFovTurns32 : 0x28000000u};
            add(draw_surface<1>(mesh->view, pose, image));
            add(draw_surface<4>(mesh->view, pose, image, {false, 2, 8192, 4, false}));
        }
    }
    INFO(std::hex << crc);
    CHECK(crc == kCrcOnEveryProcessor);
}

TEST_CASE("a stripe renderer's memory is what the documentation states", "[proxy]")
{
    constexpr uint32_t kVertices = 1262, kTriangles = 2520;
    // 16 rows of 240 pixels, one sample each; vertices in memory.
    static_assert(proxy_frame_bytes(kVertices, kTriangles, 240, 4, true) == 15182);
    static_assert(proxy_stripe_bytes(240, 16, 1) == 7680);
    // The same, vertices transformed again.
    static_assert(proxy_frame_bytes(kVertices, kTriangles, 240, 4, false) == 5086);
    // 4 rows with four samples each.
    static_assert(proxy_frame_bytes(kVertices, kTriangles, 240, 2, true) == 15300);
    static_assert(proxy_stripe_bytes(240, 4, 4) == 7680);
    static_assert(sizeof(ProxyFrame) <= 856 && sizeof(GuidedCamera) <= 264 && sizeof(ProxySurface<4>) <= 80);
    static_assert(15182 + 7680 + 856 + 264 + 80 <= 24 * 1024, "with vertices in memory");
    static_assert(5086 + 7680 + 856 + 264 + 80 <= 14 * 1024, "without");
    SUCCEED("checked by the compiler");
}
