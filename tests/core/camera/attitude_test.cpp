// SPDX-License-Identifier: MIT
#include "lumi/attitude.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "lumi/orbit.h"

using namespace lumi;

namespace
{

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
    const Axes axes = axes_of(q.w, q.x, q.y, q.z);
    const auto off = [](int32_t q30, double expected) { return std::abs(q30 / double{kOneQ30} - expected); };
    const int32_t right[] = {pose.right.x, pose.right.y, pose.right.z}, up[] = {pose.up.x, pose.up.y, pose.up.z};
    const int32_t out[] = {-pose.forward.x, -pose.forward.y, -pose.forward.z};
    double worst = 0;
    for (int k = 0; k < 3; ++k)
        worst = std::max({worst, off(right[k], axes.right[k]), off(up[k], axes.up[k]), off(out[k], axes.out[k])});
    return worst;
}

}  // namespace

TEST_CASE("a held device's pose is its quaternion's matrix, whatever the quaternion's length")
{
    std::minstd_rand random(7);
    double worst = 0;
    uint32_t refused = 0;
    for (int k = 0; k < 2000; ++k) {
        const int shift = k % 17;
        const auto number = [&] { return static_cast<int32_t>(random() - 1073741823u) >> shift; };
        const Quaternion q = {number(), number(), number(), number()};
        worst = std::max(worst, worst_of(q));
        refused += check_view(held_pose(q, radii(2)), {240, 240, degrees(40)}) != CameraError::none;
    }
    CHECK(worst < 1e-7);
    CHECK(refused == 0);
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
