// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/stepping/hits.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "chord/stepping/coarse_math.h"
#include "lumi/chord/detail/stepping/outline.h"
#include "lumi/chord/render_spans.h"
#include "lumi/detail/math.h"
#include "report.h"
#include "twin.h"
#include "views.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;
using twin::decoded;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr int32_t kSide = 24;
#else
constexpr int32_t kSide = 96;
#endif

}  // namespace

TEST_CASE("the outline follows the exact covered span from scanline to scanline", "[span]")
{
    for (const View& view : extreme_views(kSide)) {
        Camera camera;
        REQUIRE(make_camera(view.pose, view.image, camera) == CameraError::none);
        OutlineTracker outline(camera, {0, view.image.width_px});
        uint32_t off = 0;
        for (int32_t y = 0; y < view.image.height_px; ++y) {
            const Extent a = outline.scanline(y);
            const Extent b = covered_extent(camera, y, 0, view.image.width_px);
            INFO(view.name << " scanline " << y << ": " << a.begin << ".." << a.end << " and " << b.begin << ".."
                           << b.end);
            if (a.begin != b.begin || a.end != b.end) ++off;
            REQUIRE(std::abs(a.begin - b.begin) <= 1);
            REQUIRE(std::abs(a.end - b.end) <= 1);
        }
        CHECK(off <= 2);
    }
}

TEST_CASE("the sphere covers all between the columns that two scanlines share", "[span]")
{
    for (const View& view : extreme_views(kSide)) {
        Camera camera;
        REQUIRE(make_camera(view.pose, view.image, camera) == CameraError::none);
        const int32_t width = view.image.width_px;
        for (int32_t top = 0; top + 8 < view.image.height_px; top += 5) {
            OutlineTracker outline(camera, {0, width});
            const Extent middle = outline.scanline(top + 4);
            const Extent columns = outline.columns(top, top + 8, middle, 2);
            if (columns.begin >= columns.end) continue;
            INFO(view.name << " scanline " << top << ": " << columns.begin << ".." << columns.end);
            CHECK(columns.begin % 4 == 0);
            CHECK(columns.end % 4 == 0);
            for (int32_t y = top; y <= top + 8; ++y) {
                const Extent span = covered_extent(camera, y, 0, width);
                REQUIRE(columns.begin >= span.begin + (span.begin > 0 ? 3 : 0));
                REQUIRE(columns.end < span.end - (span.end < width ? 3 : 0));
            }
        }
    }
}

TEST_CASE("spans are as long as the rim allows, and end where they must", "[span]")
{
    for (const int32_t longest : {2, 4, 8, 16}) {
        const SpanLengths ramp(longest);
        for (int32_t from_left = 0; from_left < 60; ++from_left) {
            for (int32_t from_right = 1; from_right < 60; ++from_right) {
                for (const int32_t room : {1, 7, 100}) {
                    const int32_t length = ramp.length(from_left, from_right, room);
                    REQUIRE(length >= 1);
                    REQUIRE(length <= std::min({longest, from_right, room}));
                    // Never much longer than the distance from the rim.
                    REQUIRE(length <= 4 * from_left + 3);
                    REQUIRE(length <= 5 * (from_right - length) + 3);
                    const int32_t shift = SpanLengths::shift_q8(from_left, from_right - length, length);
                    REQUIRE(std::abs(shift) < 32 * length);
                    REQUIRE(std::abs(shift) <= 128 * length);
                }
            }
        }
    }
}

TEST_CASE("a span's step leads to its end", "[span]")
{
    Worst error;
    for (int32_t length = 1; length <= 16; ++length) {
        for (int32_t difference = -(1 << 21); difference < 1 << 21; difference += 997) {
            REQUIRE(is_steppable(difference));
            const double exact = static_cast<double>(difference) / length;
            REQUIRE(std::fabs(step_of(difference, length)) <= std::fabs(exact) + 16.0 / length + 1);
            error.see(std::fabs(step_of(difference, length) - exact) / (std::fabs(exact) + 65536),
                      static_cast<uint64_t>(length));
        }
    }
    CHECK(!is_steppable(1 << 21));
    CHECK(!is_steppable(-(1 << 21) - 1));
    CHECK(!is_steppable(INT32_MAX));
    error.report("step_of, share of the step and a cell");
    CHECK(error.error < std::ldexp(1.0, -10));
}

TEST_CASE("the rays of a scanline begin where the camera's 64 bits say", "[span]")
{
    for (const View& view : extreme_views(kSide)) {
        Camera camera;
        REQUIRE(make_camera(view.pose, view.image, camera) == CameraError::none);
        const HitEvaluator nodes(camera);
        for (int32_t y = 0; y < view.image.height_px; y += 7) {
            for (int32_t x = 0; x < view.image.width_px; x += 5) {
                const ScanlineRays rays = nodes.rays_from(x, y);
                const auto low_word = [](int64_t v) { return static_cast<int32_t>(static_cast<uint32_t>(v >> 12)); };
                for (int k = 0; k < 3; ++k) REQUIRE(rays.value_q28[k] == low_word(camera.offset()[k].at(x, y)));
                REQUIRE(rays.value_q28[3] == low_word(camera.facing().at(x, y)));
            }
        }
    }
}

TEST_CASE("coarse hits lie where the exact rays meet the sphere", "[span]")
{
    Worst angle;
    Worst height;
    for (const View& view : extreme_views(kSide)) {
        Camera camera;
        REQUIRE(make_camera(view.pose, view.image, camera) == CameraError::none);
        const HitEvaluator nodes(camera);
        for (int32_t y = 0; y < view.image.height_px; ++y) {
            const Extent span = covered_extent(camera, y, 0, view.image.width_px);
            if (span.begin >= span.end) continue;
            const ScanlineRays rays = nodes.rays_from(span.begin, y);
            for (int32_t x = span.begin; x < span.end; ++x) {
                SphereRay ray;
                if (!ray_at(camera, x, y, ray) || ray.half_chord2_q60 < uint64_t{1} << 54) continue;  // s > 1/8
                HitPair node;
                nodes.evaluate(rays, x - span.begin, node);
                const SphereHits truth = hits(camera, ray);
                const auto see = [&](const Hit& hit, const Vec3q30& t) {
                    const uint64_t where = static_cast<uint64_t>(y) * 1000 + static_cast<uint64_t>(x);
                    height.see(std::fabs(twin::from_q30(hit.z_q30) - twin::from_q30(t.z)), where);
                    const Vec3 v = decoded(t);
                    const double turns = hit.longitude_turns32 / 4294967296.0 - std::atan2(v.y, v.x) / (2 * twin::kPi);
                    angle.see(std::fabs(turns - std::round(turns)) * 2 * twin::kPi * std::hypot(v.x, v.y), where);
                };
                see(node.front, truth.front);
                see(node.back, truth.back);
            }
        }
    }
    height.report("coarse hit, error of z where the half chord is above 1/8");
    angle.report("coarse hit, error along the parallel where the half chord is above 1/8");
    CHECK(height.error < std::ldexp(1.0, -10));
    CHECK(angle.error < std::ldexp(1.0, -10));
}

TEST_CASE("coarse math keeps its stated errors", "[span]")
{
    Worst root;
    Worst reciprocal;
    Worst angle;
    std::minstd_rand random(3);
    for (uint32_t k = 1; k < kSweep; ++k) {
        const uint32_t v = static_cast<uint32_t>(std::ldexp(std::generate_canonical<double, 32>(random), 31));
        root.see(std::fabs(coarse_root_q15(v) - std::sqrt(v / 1073741824.0) * 32768), v);
        const CoarseReciprocal r = coarse_reciprocal(k);
        reciprocal.see(std::fabs(std::ldexp(r.mantissa, -r.exponent) * k - 1), k);
        const int32_t x = static_cast<int32_t>(std::lround(32767 * std::cos(k * 0.37)));
        const int32_t y = static_cast<int32_t>(std::lround(32767 * std::sin(k * 0.37)));
        const double turns = coarse_angle_turns32(y, x) / 4294967296.0 - std::atan2(y, x) / (2 * twin::kPi);
        angle.see(std::fabs(turns - std::round(turns)), k);
        const uint32_t large = 1 + v % 100000;
        const uint32_t small = (v >> 7) % (large + 1);
        REQUIRE(ratio_q15(small, large) == static_cast<uint32_t>((static_cast<uint64_t>(small) << 15) / large));
    }
    root.report("coarse_root_q15, units");
    reciprocal.report("coarse_reciprocal, relative error");
    angle.report("coarse_angle_turns32, turns");
    CHECK(root.error < 2);
    CHECK(reciprocal.error < std::ldexp(1.0, -14));
    CHECK(angle.error < std::ldexp(1.0, -16));
}
