// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>

#include "lumi/host/camera.h"

namespace lumi::host
{

namespace
{

constexpr double kPi = 3.14159265358979323846;

double q30(int32_t value)
{
    return value / static_cast<double>(kOneQ30);
}

}  // namespace

TEST_CASE("degrees become turns that wrap")
{
    CHECK(turns32_from_degrees(0) == 0);
    CHECK(turns32_from_degrees(90) == 0x40000000u);
    CHECK(turns32_from_degrees(360) == 0);
    CHECK(turns32_from_degrees(-90) == 0xC0000000u);
    CHECK(turns32_from_degrees(1e-12 - 1e-11) == 0);  // rounds up to a whole turn
    CHECK(signed_turns32_from_degrees(-90) == -0x40000000);
}

TEST_CASE("an orbit's eye and axes are those of spherical coordinates")
{
    double worst = 0;
    for (double azimuth = -360; azimuth <= 360; azimuth += 15)
        for (double elevation = -90; elevation <= 90; elevation += 15) {
            const Pose pose = make_pose({azimuth, elevation, 2.5});
            const double a = azimuth * kPi / 180, e = elevation * kPi / 180;
            const double eye[3] = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
            const double right[3] = {-std::sin(a), std::cos(a), 0};
            const double found[6] = {-q30(pose.forward.x), -q30(pose.forward.y), -q30(pose.forward.z),
                                     q30(pose.right.x),    q30(pose.right.y),    q30(pose.right.z)};
            for (int i = 0; i < 3; ++i) {
                worst = std::max(worst, std::abs(found[i] - eye[i]));
                worst = std::max(worst, std::abs(found[3 + i] - right[i]));
            }
            worst = std::max(worst, std::abs(pose.eye.z / static_cast<double>(kOneQ20) - 2.5 * eye[2]));
        }
    INFO("worst deviation " << worst);
    CHECK(worst < 2e-6);  // half a step of the eye's Q20, and core's rounding
}

TEST_CASE("the framing field of view shows the whole silhouette with its margin")
{
    for (const auto& [width, height] : {std::make_pair(240, 240), std::make_pair(320, 200), std::make_pair(200, 320)})
        for (const double distance : {1.5, 3.0, 100.0}) {
            const double fov = framing_fov_deg(width, height, distance);
            const double shorter = std::tan(fov * kPi / 360) * std::min(width, height) / std::max(width, height);
            const double silhouette = std::tan(std::asin(1 / distance));
            CHECK(shorter == Approx(1.06 * silhouette));
        }
    CHECK(framing_fov_deg(100, 100, 1.001) == Approx(120));
}

}  // namespace lumi::host
