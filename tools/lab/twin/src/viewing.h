// SPDX-License-Identifier: MIT
// Computes the pinhole camera of camera.h in double precision.
#pragma once

#include <algorithm>
#include <cmath>

#include "lumi/twin/geometry.h"

namespace lumi::twin
{

class Viewing
{
public:
    Viewing(const Pose& pose, const Image& image)
        : eye_(decoded(pose.eye)),
          right_(decoded(pose.right)),
          up_(decoded(pose.up)),
          forward_(decoded(pose.forward)),
          per_px_(2 * std::tan(kPi * image.fov_turns32 / kTurn) / std::max(image.width_px, image.height_px)),
          centre_x_(image.width_px / 2.0 + image.shift_x_q8 / 256.0),
          centre_y_(image.height_px / 2.0 + image.shift_y_q8 / 256.0)
    {
    }

    const Vec3& eye() const { return eye_; }

    // The viewing vector through an image position, 1 along the axis; pixel (x, y) has its centre at (x + 1/2, y +
    // 1/2).
    Vec3 vector(double x, double y) const
    {
        return forward_ + (x - centre_x_) * per_px_ * right_ - (y - centre_y_) * per_px_ * up_;
    }

    // A point's distance along the axis, and where the point appears if that is positive.
    double depth(const Vec3& p) const { return dot(p - eye_, forward_); }
    double image_x(const Vec3& p) const { return centre_x_ + dot(p - eye_, right_) / (depth(p) * per_px_); }
    double image_y(const Vec3& p) const { return centre_y_ - dot(p - eye_, up_) / (depth(p) * per_px_); }

private:
    static constexpr double kTurn = 4294967296.0;

    Vec3 eye_, right_, up_, forward_;
    double per_px_, centre_x_, centre_y_;
};

}  // namespace lumi::twin
