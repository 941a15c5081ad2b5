// SPDX-License-Identifier: MIT
#include "lumi/proxy_surface.h"

#include <catch2/catch.hpp>
#include <random>

#include "lumi/reference/guided_picture.h"
#include "proxy_drawing.h"

using namespace lumi;
using namespace lumi::test;
using reference::ProxyHit;
using reference::Vec3;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr int32_t kSidePx = 10;
constexpr int kRandomViews = 3;
constexpr uint32_t kBallSteps = 6;
constexpr size_t kViewStep = 3;
#else
constexpr int32_t kSidePx = 72;
constexpr int kRandomViews = 60;
constexpr uint32_t kBallSteps = 24;
constexpr size_t kViewStep = 1;
#endif

// Of "the same bits"; a change of the arithmetic changes it, a processor must not.
constexpr uint32_t kCrcOnEveryProcessor = 0x7C51795E;

// The views at the ends of every range, some of them on an emulated board.
std::vector<View> views()
{
    const std::vector<View> all = extreme_views(kSidePx);
    std::vector<View> chosen;
    for (size_t k = 0; k < all.size(); k += kViewStep) chosen.push_back(all[k]);
    return chosen;
}

// What rays against triangles see, through every sample's place and through four places 1/16 of a pixel around it: the
// rasterizer rounds vertices to 1/64 of a sample and may answer for any ray in between.
constexpr int kPlaces = 5;
constexpr int32_t kPlaceQ8[kPlaces][2] = {{0, 0}, {16, 0}, {-16, 0}, {0, 16}, {0, -16}};

struct Truth {
    std::vector<ProxyHit> hits[kPlaces];

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

// The step of a depth in the buffer, in radii at depth z, as docs/architecture.md states it.
double depth_step(const ProxyMesh& mesh, const Pose& pose, double z)
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

// Vertices, edges, gradients and the buffer round depths: together at most this many steps.
constexpr double kStepsOff = 4;

Vec3 point_of(const SurfacePoint& p)
{
    return {p.x_q14 / 16384.0, p.y_q14 / 16384.0, p.z_q14 / 16384.0};
}

struct Findings {
    int wrong_hits = 0, undecided = 0, seen = 0;
    double worst = 0;  // error beyond what the ray's place explains, in steps of the bound
    int32_t worst_x = 0, worst_y = 0;
};

// Where a hit is nearer than the near plane, anything may be seen behind it.
bool is_cut(const ProxyHit& hit)
{
    return hit.hit && hit.depth < 1.2 / 256;
}

Findings compare_centres(const ProxyMesh& mesh, const Pose& pose, const Image& image,
                         const DrawingOptions& options = {})
{
    const Truth truth(mesh, pose, image, false);
    const SurfacePicture picture = draw_surface<1>(mesh, pose, image, options);
    REQUIRE(picture.height_px == image.height_px);
    GuidedCamera camera;
    REQUIRE(make_guided_camera(pose, image, camera) == CameraError::none);
    Findings f;
    for (int32_t y = 0; y < image.height_px; ++y) {
        for (int32_t x = 0; x < image.width_px; ++x) {
            SphereRay ray;
            if (!ray_at(camera.camera, x, y, ray)) continue;
            const size_t k = static_cast<size_t>(y) * static_cast<size_t>(image.width_px) + static_cast<size_t>(x);
            const int hits = truth.hit_count(k);
            const ProxyHit& centre = truth.hits[0][k];
            const auto& seen = picture.at(x, y);
            ++f.seen;
            const double spread = truth.spread(k);
            if ((hits != 0 && hits != kPlaces) || is_cut(centre) || (hits != 0 && spread > 0.05)) {
                ++f.undecided;
                continue;
            }
            if (seen.size() != (hits != 0 ? 1u : 0u)) ++f.wrong_hits;
            if (hits == 0 || seen.empty()) continue;
            const double bound = 0.001 + kStepsOff * depth_step(mesh, pose, centre.depth) + spread;
            const double error = reference::length(point_of(seen[0]) - centre.x) / bound;
            if (error > f.worst) f.worst = error, f.worst_x = x, f.worst_y = y;
        }
    }
    return f;
}

// The same for four samples a pixel: how many see the surface, and X where one surface fills the pixel.
Findings compare_samples(const ProxyMesh& mesh, const Pose& pose, const Image& image,
                         const DrawingOptions& options = {})
{
    const Truth truth(mesh, pose, image, true);
    const SurfacePicture picture = draw_surface<4>(mesh, pose, image, options);
    REQUIRE(picture.height_px == image.height_px);
    GuidedCamera camera;
    REQUIRE(make_guided_camera(pose, image, camera) == CameraError::none);
    Findings f;
    for (int32_t y = 0; y < image.height_px; ++y) {
        for (int32_t x = 0; x < image.width_px; ++x) {
            SphereRay ray;
            if (!ray_at(camera.camera, x, y, ray)) continue;
            const size_t first =
                4 * (static_cast<size_t>(y) * static_cast<size_t>(image.width_px) + static_cast<size_t>(x));
            ++f.seen;
            uint32_t expected = 0, found = 0;
            bool decided = true;
            double spread = 0;
            Vec3 mean = {0, 0, 0};
            for (size_t k = first; k < first + 4; ++k) {
                const int hits = truth.hit_count(k);
                decided = decided && (hits == 0 || hits == kPlaces) && !is_cut(truth.hits[0][k]);
                expected += hits != 0;
                mean = mean + 0.25 * truth.hits[0][k].x;
                spread =
                    std::max({spread, truth.spread(k), reference::length(truth.hits[0][k].x - truth.hits[0][first].x)});
            }
            if (!decided) {
                ++f.undecided;
                continue;
            }
            for (const SurfacePoint& p : picture.at(x, y)) found += p.samples;
            if (found != expected) ++f.wrong_hits;
            if (expected != 4 || picture.at(x, y).size() != 1 || spread > 0.02) continue;
            const double bound = 0.001 + kStepsOff * depth_step(mesh, pose, truth.hits[0][first].depth) + 0.25 * spread;
            const double error = reference::length(point_of(picture.at(x, y)[0]) - mean) / bound;
            if (error > f.worst) f.worst = error, f.worst_x = x, f.worst_y = y;
        }
    }
    return f;
}

void check(const Findings& f)
{
    INFO("seen " << f.seen << ", undecided " << f.undecided << ", worst at " << f.worst_x << ", " << f.worst_y);
    CHECK(f.wrong_hits == 0);
    CHECK(f.worst <= 1);
}

struct NamedMesh {
    const char* name;
    TestMesh mesh;
};

std::vector<NamedMesh> meshes()
{
    return {{"wavy ball", ball(kBallSteps, kBallSteps, 0.65, 0.1)},
            {"full sphere", ball(kBallSteps, 16, 0.985)},
            {"plate", plate(0.7)},
            {"needle", needle()}};
}

Vec3 random_direction(std::mt19937& random)
{
    std::uniform_real_distribution<double> uniform(-1, 1);
    while (true) {
        const Vec3 v = {uniform(random), uniform(random), uniform(random)};
        const double length = reference::length(v);
        if (length > 0.1 && length < 1) return (1 / length) * v;
    }
}

uint32_t random_below(std::mt19937& random, uint32_t end)
{
    return static_cast<uint32_t>(random() % end);
}

// Triangles of any size anywhere in the cube, which the file can hold although the sphere cuts its corners off.
TestMesh soup(std::mt19937& random, uint32_t triangles)
{
    TestMesh mesh;
    for (uint32_t k = 0; k < 3 * triangles; ++k) {
        const bool anywhere = k % 3 == 0 || k % 6 < 3;
        const Triple base = anywhere ? Triple{} : mesh.vertices[k - k % 3];
        const auto number = [&](uint32_t from) {
            return std::min<uint32_t>(4095, from + random_below(random, anywhere ? 4096 : 200));
        };
        mesh.vertices.push_back({number(base[0]), number(base[1]), number(base[2])});
        if (k % 3 == 2) mesh.triangles.push_back({k - 2, k - 1, k});
    }
    mesh.flags = random_below(random, 2) == 0 ? format::kTwoSided : 0;
    return mesh;
}

}  // namespace

TEST_CASE("surfaces at the ends of every range lie where rays meet the mesh", "[proxy]")
{
    for (const NamedMesh& m : meshes()) {
        const PackedMesh mesh(m.mesh);
        for (const View& view : views()) {
            INFO(m.name << ", " << view.name);
            check(compare_centres(mesh.view, view.pose, view.image));
            check(compare_samples(mesh.view, view.pose, view.image));
        }
    }
}

TEST_CASE("surfaces from random views lie where rays meet the mesh", "[proxy]")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    const std::vector<NamedMesh> all = meshes();
    for (int k = 0; k < kRandomViews; ++k) {
        const NamedMesh& m = all[static_cast<size_t>(k) % all.size()];
        const double distance = 1.01 + std::pow(uniform(random), 3) * 8;
        const Vec3 eye = distance * random_direction(random), target = 0.8 * random_direction(random);
        const Pose pose = look_at(eye, target, 360 * uniform(random));
        const Image image = {kSidePx, kSidePx, degrees(5 + 110 * uniform(random))};
        INFO(m.name << ", view " << k << " from " << distance);
        const PackedMesh mesh(m.mesh);
        check(compare_centres(mesh.view, pose, image));
        check(compare_samples(mesh.view, pose, image));
    }
}

TEST_CASE("a plate is seen at grazing angles down to its edge", "[proxy]")
{
    const PackedMesh mesh(plate(0.7));
    for (const double height : {0.3, 0.05, 0.01, 0.002, 0.0}) {
        INFO("eye " << height << " above the plate");
        check(compare_centres(mesh.view, look_at({1.3, 0.4, height}, {0, 0, 0}), {kSidePx, kSidePx, degrees(70)}));
    }
}

TEST_CASE("triangles of any size, through the near plane and beside the image, are drawn where they are", "[proxy]")
{
    std::mt19937 random(11);
    for (int k = 0; k < kRandomViews; ++k) {
        const PackedMesh mesh(soup(random, 12));
        const double distance = k % 2 == 0 ? 1.01 : 1.5;
        const Pose pose = look_at(distance * random_direction(random), random_direction(random));
        const Image image = {kSidePx, kSidePx / 2, degrees(k % 3 == 0 ? 4 : 100)};
        INFO("soup " << k);
        check(compare_centres(mesh.view, pose, image));
        check(compare_samples(mesh.view, pose, image));
    }
}

TEST_CASE("empty and degenerate meshes show nothing", "[proxy]")
{
    TestMesh points;
    points.vertices = {vertex_at(0, 0, 0), vertex_at(0.5, 0, 0), vertex_at(0.25, 0, 0)};
    points.triangles = {{0, 0, 0}, {0, 1, 1}, {1, 0, 1}, {2, 2, 0}};
    points.flags = format::kTwoSided;
    TestMesh unused = points;
    unused.triangles.clear();
    for (const TestMesh& m : {TestMesh{}, unused, points}) {
        const PackedMesh mesh(m);
        for (const View& view : views()) {
            INFO(view.name);
            const SurfacePicture picture = draw_surface<4>(mesh.view, view.pose, view.image);
            size_t seen = 0;
            for (const auto& pixel : picture.pixels) seen += pixel.size();
            CHECK(seen == 0);
        }
    }
}

TEST_CASE("one-sided triangles are seen from outside alone, two-sided ones from both sides", "[proxy]")
{
    TestMesh one = plate(0.7);
    one.flags = 0;
    const PackedMesh one_sided(one), two_sided(plate(0.7));
    const Image image = {16, 16, degrees(40)};
    const Pose above = look_at({0.3, 0, 2}, {0, 0, 0}), below = look_at({0.3, 0, -2}, {0, 0, 0});
    CHECK(draw_surface<1>(one_sided.view, above, image).at(8, 8).size() == 1);
    CHECK(draw_surface<1>(one_sided.view, below, image).at(8, 8).empty());
    CHECK(draw_surface<1>(two_sided.view, above, image).at(8, 8).size() == 1);
    CHECK(draw_surface<1>(two_sided.view, below, image).at(8, 8).size() == 1);
}

namespace
{

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
    for (int k = 0; k < kRandomViews / 2; ++k) {
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
