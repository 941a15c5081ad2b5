// SPDX-License-Identifier: MIT
// Makes the viewing rays of core's camera in floating point.
#pragma once

#include <optional>

#include "geometry/accelerator.h"
#include "lumi/chord/camera.h"

namespace lumi::baker
{

class CameraRays
{
public:
    explicit CameraRays(const Camera& camera);

    // The ray through image position (x, y), pixel centres at +1/2, from where it enters the unit sphere; nothing if it
    // passes the sphere by.
    std::optional<Ray> ray(double x, double y) const;

private:
    struct Vec3d {
        double x, y, z;
    };

    // Is a linear function of the pixel, given at the centre of pixel (0,0) and per step.
    struct Affine {
        double at_first, step_x, step_y;
        double at(double sx, double sy) const { return at_first + sx * step_x + sy * step_y; }
    };
    static Affine decoded(const detail::AffineQ40& q);

    double inverse_distance_;  // 1/e
    Vec3d eye_direction_;      // ê
    Affine facing_;            // m
    Affine offset_[3];         // P
};

}  // namespace lumi::baker
