// SPDX-License-Identifier: MIT
// Cameras for tests: any pose from double precision, and the views at the ends of every stated range.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "lumi/camera.h"
#include "twin.h"

namespace lumi::test
{

using twin::Vec3;

inline Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline uint32_t degrees(double d)
{
    return static_cast<uint32_t>(std::llround(d / 360 * 4294967296.0));
}

// An eye that looks at a target, turned by `roll` degrees around its axis.
inline Pose look_at(const Vec3& eye, const Vec3& target, double roll = 0)
{
    const Vec3 forward = twin::normalised(target - eye);
    const Vec3 helper = std::fabs(forward.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    const Vec3 level = twin::normalised(cross(forward, helper));
    const Vec3 upright = cross(level, forward);
    const double c = std::cos(roll * twin::kPi / 180);
    const double s = std::sin(roll * twin::kPi / 180);
    const auto q20 = [](double v) { return static_cast<int32_t>(std::lround(v * kOneQ20)); };
    return {{q20(eye.x), q20(eye.y), q20(eye.z)},
            twin::encoded(c * level + s * upright),
            twin::encoded(c * upright + (-s) * level),
            twin::encoded(forward)};
}

struct View {
    std::string name;
    Pose pose;
    Image image;
    bool visible = true;
};

inline std::vector<View> extreme_views(int32_t side)
{
    const Vec3 centre = {0, 0, 0};
    const Vec3 a = {1.9, -1.1, 1.3};
    const Vec3 close = 1.01 * twin::normalised({0.3, 0.8, -0.5});
    const Vec3 far = 1000.0 * twin::normalised({-0.2, 0.6, 0.7});
    return {
        {"generic", look_at(a, centre, 20), {side, side, degrees(45)}},
        {"down the pole", look_at({0, 0, 2.6}, centre), {side, side, degrees(46)}},
        {"up the pole", look_at({0, 0, -2.6}, centre, 77), {side, side, degrees(46)}},
        {"pole close by", look_at({0.01, 0.02, 1.1}, {0.05, 0, 0}), {side, side, degrees(40)}},
        {"across the seam", look_at({2.5, 0, 0}, centre), {side, side, degrees(48)}},
        {"eye on the sphere", look_at({1, 0, 0}, centre), {side, side, degrees(90)}},
        {"eye at 1.01 R", look_at(close, centre), {side, side, degrees(120)}},
        {"eye at 1.01 R, along the surface", look_at(close, {0.9, -0.8, 0.3}), {side, side, degrees(100)}},
        {"eye at 1000 R, 2 degrees", look_at(far, centre), {side, side, degrees(2)}},
        {"eye at 2047 R, 1 degree", look_at({0, -2046.9, 0}, centre), {side, side, degrees(1)}},
        {"2 degrees from near by", look_at(a, {0.2, 0.1, 0}), {side, side, degrees(2)}},
        {"120 degrees", look_at(a, centre, -30), {side, side, degrees(120)}},
        {"partly off screen", look_at(a, {1.2, 1, 0.5}), {side, side, degrees(40)}},
        {"wholly off screen", look_at(a, {9, 1, 0.5}), {side, side, degrees(30)}, false},
        {"behind the eye", look_at(a, {3.8, -2.2, 2.6}), {side, side, degrees(120)}, false},
        {"one pixel", look_at(a, centre), {1, 1, degrees(10)}},
        {"one column", look_at(a, centre), {1, side, degrees(50)}},
        {"one row", look_at(a, centre), {side, 1, degrees(50)}},
        {"shifted lens", look_at(a, centre), {side, side, degrees(45), side * 100, -side * 60}},
        {"wide and odd", look_at(a, centre), {side * 2 + 1, side / 2 + 1, degrees(70)}},
    };
}

// Anywhere around the sphere, rather close by, looking somewhere near its centre.
inline View random_view(std::minstd_rand& random, int32_t side)
{
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 32>(random);
    };
    const double z = uniform(-1, 1);
    const double angle = uniform(0, 2 * twin::kPi);
    const double distance = 1.01 + std::pow(uniform(0, 1), 3) * 6;
    const double r = std::sqrt(1 - z * z);
    const Vec3 eye = distance * Vec3{r * std::cos(angle), r * std::sin(angle), z};
    const Vec3 target = {uniform(-0.4, 0.4), uniform(-0.4, 0.4), uniform(-0.4, 0.4)};
    return {"random", look_at(eye, target, uniform(0, 360)), {side, side, degrees(uniform(20, 110))}};
}

}  // namespace lumi::test
