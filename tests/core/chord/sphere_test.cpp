// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/sphere.h"

#include <catch2/catch.hpp>

#include "report.h"
#include "twin.h"
#include "views.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;
using twin::decoded;

namespace
{

// The ray of a pixel as the camera's numbers describe it, and the plain quadratic equation for its hits.
struct TwinRay {
    Vec3 eye, direction;
    bool covered;
    double margin;  // the tangent rule's margin: s²/q - 1/2^kTangentShift
    Vec3 front, back;
};

TwinRay twin_ray(const Camera& camera, int32_t x, int32_t y)
{
    const auto value = [&](const AffineQ40& a) { return std::ldexp(static_cast<double>(a.at(x, y)), -40); };
    const double inverse = twin::from_q30(camera.inverse_distance_q30());
    const Vec3 axis = decoded(camera.eye_direction());
    const Vec3 p = {value(camera.offset()[0]), value(camera.offset()[1]), value(camera.offset()[2])};
    TwinRay ray{};
    ray.eye = (1 / inverse) * axis;
    ray.direction = twin::normalised(inverse * p + (-value(camera.facing())) * axis);
    const double along = -twin::dot(ray.eye, ray.direction);
    const double half2 = along * along - (twin::dot(ray.eye, ray.eye) - 1);
    ray.margin = half2 - std::ldexp(1.0, -kTangentShift);
    ray.covered = ray.margin >= 0 && along > 0;
    const double half = std::sqrt(std::fmax(0.0, half2));
    ray.front = ray.eye + (along - half) * ray.direction;
    ray.back = ray.eye + (along + half) * ray.direction;
    return ray;
}

Camera camera_of(const View& view)
{
    Camera camera;
    REQUIRE(make_camera(view.pose, view.image, camera) == CameraError::none);
    return camera;
}

// Two roundings of s²: the tangent rule may fall either way this close to its border.
constexpr double kBorder = 1e-5;

}  // namespace

TEST_CASE("hits agree with the quadratic equation at every extreme", "[sphere]")
{
    for (const View& view : extreme_views(40)) {
        const Camera camera = camera_of(view);
        Worst worst;
        uint32_t undecided = 0;
        uint32_t covered = 0;
        for (int32_t y = 0; y < view.image.height_px; ++y) {
            for (int32_t x = 0; x < view.image.width_px; ++x) {
                const TwinRay truth = twin_ray(camera, x, y);
                SphereRay ray;
                const bool drawn = ray_at(camera, x, y, ray);
                covered += drawn;
                if (drawn != truth.covered) {
                    undecided += 1;
                    INFO(view.name << " pixel " << x << ", " << y << " margin " << truth.margin);
                    REQUIRE(std::fabs(truth.margin) < kBorder);
                } else if (drawn) {
                    const SphereHits hit = hits(camera, ray);
                    const uint64_t where = static_cast<uint64_t>(y) * 1000 + static_cast<uint64_t>(x);
                    worst.see(twin::length(decoded(hit.front) - truth.front), where);
                    worst.see(twin::length(decoded(hit.back) - truth.back), where);
                }
            }
        }
        worst.report(("hits, " + view.name + ", " + std::to_string(covered) + " pixels").c_str());
        INFO(view.name);
        // 2^-25 in the frame; a far eye's direction is known to 2^-30 of its distance.
        CHECK(worst.error < std::ldexp(1.0, -17));
        CHECK(undecided <= 2);
        CHECK((covered > 0) == view.visible);
    }
}

TEST_CASE("a scanline's span holds exactly the pixels that ray_at covers", "[sphere]")
{
    for (const View& view : extreme_views(40)) {
        const Camera camera = camera_of(view);
        const Extent ranges[] = {{0, view.image.width_px}, {-30, view.image.width_px + 30}, {7, 8}, {11, 29}, {5, 5}};
        for (int32_t y = -20; y < view.image.height_px + 20; ++y) {
            for (const Extent& range : ranges) {
                const Extent span = covered_extent(camera, y, range.begin, range.end);
                REQUIRE(span.begin >= range.begin);
                REQUIRE(span.end <= std::max(range.begin, range.end));
                std::vector<int32_t> wrong;
                for (int32_t x = range.begin; x < range.end; ++x) {
                    SphereRay ray;
                    const bool inside = x >= 0 && x < view.image.width_px && y >= 0 && y < view.image.height_px;
                    const bool is_hit = inside && ray_at(camera, x, y, ray);
                    if (is_hit != (x >= span.begin && x < span.end)) wrong.push_back(x);
                }
                INFO(view.name << " scanline " << y << " span " << span.begin << ".." << span.end);
                REQUIRE(wrong == std::vector<int32_t>{});
            }
        }
    }
}
