// SPDX-License-Identifier: MIT
#include "measure/extreme_views.h"

#include <cmath>

#include "lumi/orbit.h"
#include "lumi/twin/picture.h"

namespace lumi::lab
{

namespace
{

constexpr double kTurn = 4294967296.0;

int32_t radii_q20(double r)
{
    return static_cast<int32_t>(std::lround(r * kOneQ20));
}

}  // namespace

Pose from(double azimuth_deg, double elevation_deg, double distance)
{
    const auto turns = [](double degrees) { return static_cast<int64_t>(degrees / 360 * kTurn); };
    return detail::orbit(static_cast<uint32_t>(turns(azimuth_deg)), static_cast<int32_t>(turns(elevation_deg)),
                         radii_q20(distance));
}

Pose rolled(const Pose& pose, double degrees)
{
    const double c = std::cos(degrees * twin::kPi / 180), s = std::sin(degrees * twin::kPi / 180);
    const twin::Vec3 right = twin::decoded(pose.right), up = twin::decoded(pose.up);
    return {pose.eye, twin::encoded(c * right + s * up), twin::encoded(c * up - s * right), pose.forward};
}

std::vector<View> around(double distance, const Image& image)
{
    std::vector<View> views;
    for (const double elevation : {-75.0, -20.0, 10.0, 50.0})
        views.push_back({from(3 * elevation + 137, elevation, distance), image});
    return views;
}

std::vector<View> stereo()
{
    Image shifted = kUsual;
    shifted.shift_x_q8 = 30 * 256 + 77;
    shifted.shift_y_q8 = -20 * 256;
    const Pose pose = from(30, 20, 1.6);
    return {{moved_right(pose, radii_q20(-0.2)), kUsual}, {moved_right(pose, radii_q20(0.2)), kUsual}, {pose, shifted}};
}

}  // namespace lumi::lab
