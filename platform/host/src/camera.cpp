// SPDX-License-Identifier: MIT
#include "lumi/host/camera.h"

#include <algorithm>
#include <cmath>

namespace lumi::host
{

namespace
{

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegreesPerTurn = 360;
constexpr double kTurn = 4294967296.0;  // one turn in turns32
constexpr double kMaxFovDeg = 120;

double degrees_from_radians(double radians)
{
    return radians * 180 / kPi;
}

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
    return lumi::orbit(turns32_from_degrees(orbit.azimuth_deg), signed_turns32_from_degrees(orbit.elevation_deg),
                       q20_from_radii(orbit.distance));
}

Image make_image(int32_t width_px, int32_t height_px, double fov_deg)
{
    return {width_px, height_px, turns32_from_degrees(fov_deg)};
}

double framing_fov_deg(int32_t width_px, int32_t height_px, double distance)
{
    // The silhouette is a cone of half angle asin(1/e); the longer side shows more by the ratio of the sides.
    const double tangent = std::tan(std::asin(1 / distance)) * kFramingMargin;
    const double ratio = static_cast<double>(std::max(width_px, height_px)) / std::min(width_px, height_px);
    return std::min(kMaxFovDeg, 2 * degrees_from_radians(std::atan(tangent * ratio)));
}

}  // namespace lumi::host
