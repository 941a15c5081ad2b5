// SPDX-License-Identifier: MIT
#include "quality/held_out.h"

#include <cmath>
#include <cstdio>

#include "terminal/failure.h"

namespace lumi::quality
{

namespace
{

constexpr double kNearest = 2.5, kFarthest = 4;
constexpr double kTurnDeg = 77, kDegrees = 360;
constexpr double kPi = 3.14159265358979323846;
constexpr double kGolden = 1.61803398874989484820;

double fraction(double v)
{
    return v - std::floor(v);
}

double degrees(double radians)
{
    return radians * kDegrees / (2 * kPi);
}

double elevation_deg(ViewSet set, int k, int count, double cap)
{
    constexpr double kRingLow = 15, kRingHeight = 10;
    const double share = (k + 0.5) / count;
    if (set == ViewSet::ring) return kRingLow + kRingHeight * fraction(5 * share);
    return degrees(std::asin(set == ViewSet::upper ? 1 - share : 1 - 2 * cap * share));
}

}  // namespace

const char* name_of(ViewSet set)
{
    switch (set) {
        case ViewSet::all:
            return "all";
        case ViewSet::upper:
            return "upper";
        case ViewSet::ring:
            return "ring";
    }
    return "unknown";
}

HeldOutView view_at(double azimuth_deg, double elevation_deg, double distance, int side_px)
{
    HeldOutView v = {azimuth_deg, elevation_deg, distance, {}};
    v.eye.pose = host::make_pose({azimuth_deg, elevation_deg, distance});
    v.eye.image = host::make_image(side_px, side_px, host::framing_fov_deg(side_px, side_px, distance));
    if (const CameraError error = make_camera(v.eye.pose, v.eye.image, v.eye.camera); error != CameraError::none)
        throw tools::UsageError(std::string("a view cannot be drawn: ") + describe(error) + "; change --size");
    return v;
}

std::vector<HeldOutView> held_out_views(ViewSet set, int count, int side_px, double cap)
{
    std::vector<HeldOutView> views;
    for (int k = 0; k < count; ++k) {
        const double azimuth = set == ViewSet::ring ? kDegrees * k / count : kDegrees * fraction(k / kGolden);
        const double distance = kNearest + (kFarthest - kNearest) * fraction((k + 0.5) * 5 / 12);
        views.push_back(view_at(azimuth + kTurnDeg, elevation_deg(set, k, count, cap), distance, side_px));
    }
    return views;
}

std::string text_of(const HeldOutView& view)
{
    char text[80];
    std::snprintf(text, sizeof text, "azimuth %.0f, elevation %.0f, distance %.2f",
                  fraction(view.azimuth_deg / kDegrees) * kDegrees, view.elevation_deg, view.distance);
    return text;
}

}  // namespace lumi::quality
