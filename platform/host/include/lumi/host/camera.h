// SPDX-License-Identifier: MIT
// Cameras are made from degrees and radii: people's units on one side, core's fixed point on the other.
#pragma once

#include "lumi/chord/camera.h"

namespace lumi::host
{

// An eye that looks at the centre of the sphere; see lumi::orbit for the frame.
struct Orbit {
    double azimuth_deg = 0;    // any value; 0 looks from +x, 90 from +y
    double elevation_deg = 0;  // -90 .. 90
    double distance = 3;       // from the centre, in radii
    double roll_deg = 0;       // turns the picture clockwise
};

// Conversions round to nearest. Angles wrap to one turn; lengths must lie in [-2048, 2048).
uint32_t turns32_from_degrees(double degrees);
int32_t signed_turns32_from_degrees(double degrees);
int32_t q20_from_radii(double radii);

// Returns the pose of an orbit. Precondition: elevation and distance are in range (make_camera checks the distance
// again).
Pose make_pose(const Orbit& orbit);

// Returns a centred image whose longer side spans `fov_deg`. Precondition: 0 <= fov_deg < 360.
Image make_image(int32_t width_px, int32_t height_px, double fov_deg);

// The field of view, in degrees over the longer side, at which the sphere seen from `distance` radii fills the shorter
// side: core's fit_sphere, so that firmware and tool show the same. Precondition: distance > 1, sides positive.
double framing_fov_deg(int32_t width_px, int32_t height_px, double distance);

}  // namespace lumi::host
