// SPDX-License-Identifier: MIT
#include "lumi/attitude.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "lumi/chord/camera.h"
#include "lumi/orbit.h"
#include "lumi/surface/frame.h"

using namespace lumi;
using namespace lumi::detail;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr int kTurns = 600, kMost = 1;
constexpr int32_t kLengths[] = {1, 16384, INT32_MAX / kMost};
#else
constexpr int kTurns = 20000, kMost = 3;
constexpr int32_t kLengths[] = {1, 2, 100, 16384, 23170, 1 << 28, (1 << 29) - 1, 1 << 29, INT32_MAX / kMost};
#endif

// The pose by doubles: columns of the quaternion's matrix.
struct Axes {
    double right[3], up[3], out[3];
};

Axes axes_of(double w, double x, double y, double z)
{
    const double n = std::sqrt(w * w + x * x + y * y + z * z);
    w /= n, x /= n, y /= n, z /= n;
    return {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
            {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
            {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
}

double worst_of(const Quaternion& q)
{
    const Pose pose = held_pose(q, radii(3));
    const bool is_none = (q.w | q.x | q.y | q.z) == 0;
    const Axes axes = axes_of(is_none ? 1 : q.w, q.x, q.y, q.z);
    const auto off = [](int32_t q30, double expected) { return std::abs(q30 / double{kOneQ30} - expected); };
    const int32_t right[] = {pose.right.x, pose.right.y, pose.right.z}, up[] = {pose.up.x, pose.up.y, pose.up.z};
    const int32_t out[] = {-pose.forward.x, -pose.forward.y, -pose.forward.z};
    double worst = 0;
    for (int k = 0; k < 3; ++k)
        worst = std::max({worst, off(right[k], axes.right[k]), off(up[k], axes.up[k]), off(out[k], axes.out[k])});
    return worst;
}

bool is_accepted(const Pose& pose)
{
    const Image image = {240, 240, degrees(40)};
    Camera camera;
    SurfaceCamera surface_camera;
    return make_camera(pose, image, camera) == CameraError::none &&
           make_surface_camera(pose, image, surface_camera) == CameraError::none;
}

// Collects what a set of turns shows, each of them held at both ends of the distances and at one between.
struct Held {
    double worst = 0;
    uint32_t turns = 0, refused = 0;

    void see(const Quaternion& q)
    {
        ++turns;
        worst = std::max(worst, worst_of(q));
        for (const int32_t distance : {radii(1), radii(2), kMaxEyeDistanceQ20})
            refused += is_accepted(held_pose(q, distance)) ? 0u : 1u;
    }
    void check() const
    {
        INFO(turns << " turns");
        CHECK(worst < 1e-7);
        CHECK(refused == 0);
    }
};

int32_t rounded(double v)
{
    return static_cast<int32_t>(std::lround(std::clamp(v, double{INT32_MIN}, double{INT32_MAX})));
}

}  // namespace

TEST_CASE("quaternions of the smallest numbers, all turns about axes and diagonals among them, are held at any length")
{
    Held held;
    for (const int32_t length : kLengths)
        for (int w = -kMost; w <= kMost; ++w)
            for (int x = -kMost; x <= kMost; ++x)
                for (int y = -kMost; y <= kMost; ++y)
                    for (int z = -kMost; z <= kMost; ++z) held.see({w * length, x * length, y * length, z * length});
    for (int k = 0; k < 256; ++k) {
        const int32_t ends[] = {0, INT32_MIN, INT32_MAX, 1 << 30};
        held.see({ends[k & 3], ends[k >> 2 & 3], ends[k >> 4 & 3], ends[k >> 6]});
    }
    held.check();
}

TEST_CASE("half turns about any axis, and turns near them, are held at any length")
{
    std::minstd_rand random(11);
    std::normal_distribution<double> normal;
    const double lengths[] = {1, 20, 16384, 1 << 20, 1 << 30, 2147483647.0};
    Held held;
    for (int k = 0; k < kTurns; ++k) {
        const double length = lengths[k % 6], off = k % 5 == 0 ? 0 : std::ldexp(normal(random), -(k % 29));
        const double axis[] = {normal(random), normal(random), normal(random)};
        const double scale = length / std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2] + off * off);
        held.see({rounded(off * scale), rounded(axis[0] * scale), rounded(axis[1] * scale), rounded(axis[2] * scale)});
    }
    held.check();
}

TEST_CASE("a held device's pose is its quaternion's matrix, whatever the quaternion's length")
{
    std::minstd_rand random(7);
    Held held;
    for (int k = 0; k < 2000; ++k) {
        const int shift = k % 17;
        const auto number = [&] { return static_cast<int32_t>(random() - 1073741823u) >> shift; };
        held.see({number(), number(), number(), number()});
    }
    held.check();
}

TEST_CASE("a device that lies flat shows the object from above, and one that stands up from the front")
{
    const Pose flat = held_pose({1, 0, 0, 0}, radii(3));
    CHECK(flat.eye.z == radii(3));
    CHECK(flat.up.y == kOneQ30);
    const Pose nothing = held_pose({0, 0, 0, 0}, radii(3));
    CHECK(nothing.eye.z == radii(3));
    // A quarter turn about x: the display's up is the sphere's up.
    const Pose standing = held_pose({23170, 23170, 0, 0}, radii(3));
    CHECK(std::abs(standing.up.z - kOneQ30) < 8);
    CHECK(standing.eye.y < -radii(3) + 8);
}
