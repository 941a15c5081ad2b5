// SPDX-License-Identifier: MIT
#include "lumi/host/camera.h"

#include <cmath>

#include "lumi/orbit.h"

namespace lumi::host
{

namespace
{

constexpr double kDegreesPerTurn = 360;
constexpr double kTurn = 4294967296.0;  // one turn in turns32

}  // namespace

uint32_t turns32_from_degrees(double degrees)
{
    const double turns = degrees / kDegreesPerTurn;
    const double fraction = turns - std::floor(turns);
    return static_cast<uint32_t>(static_cast<uint64_t>(std::llround(fraction * kTurn)));
}

int32_t signed_turns32_from_degrees(double degrees)
{
    return static_cast<int32_t>(turns32_from_degrees(degrees));
}

int32_t q20_from_radii(double radii)
{
    return static_cast<int32_t>(std::lround(radii * kOneQ20));
}

Pose make_pose(const Orbit& orbit)
{
    const Pose upright =
        lumi::detail::orbit(turns32_from_degrees(orbit.azimuth_deg), signed_turns32_from_degrees(orbit.elevation_deg),
                            q20_from_radii(orbit.distance));
    return rolled(upright, turns32_from_degrees(orbit.roll_deg));
}

Image make_image(int32_t width_px, int32_t height_px, double fov_deg)
{
    return {width_px, height_px, turns32_from_degrees(fov_deg)};
}

double framing_fov_deg(int32_t width_px, int32_t height_px, double distance)
{
    return fit_sphere(width_px, height_px, q20_from_radii(distance)) * (kDegreesPerTurn / kTurn);
}

}  // namespace lumi::host
