// SPDX-License-Identifier: MIT
#include "trace/camera_rays.h"

namespace lumi::baker
{
namespace
{

constexpr double kUnitQ30 = 0x1p-30;
constexpr double kUnitQ40 = 0x1p-40;

}  // namespace

CameraRays::Affine CameraRays::decoded(const detail::AffineQ40& q)
{
    return {static_cast<double>(q.at_first) * kUnitQ40, static_cast<double>(q.step_x) * kUnitQ40,
            static_cast<double>(q.step_y) * kUnitQ40};
}

CameraRays::CameraRays(const Camera& c)
    : inverse_distance_(c.inverse_distance_q30() * kUnitQ30),
      eye_direction_{c.eye_direction().x * kUnitQ30, c.eye_direction().y * kUnitQ30, c.eye_direction().z * kUnitQ30},
      facing_(decoded(c.facing())),
      offset_{decoded(c.offset()[0]), decoded(c.offset()[1]), decoded(c.offset()[2])}
{
}

std::optional<Ray> CameraRays::ray(double x, double y) const
{
    // Steps count from the centre of pixel (0,0).
    const double sx = x - 0.5, sy = y - 0.5;
    const double m = facing_.at(sx, sy);
    const Vec3d p = {offset_[0].at(sx, sy), offset_[1].at(sx, sy), offset_[2].at(sx, sy)};
    // The front intersection h of lumi/camera.h, and D = P/e - m·ê.
    const Vec3d& e = eye_direction_;
    const double p2 = p.x * p.x + p.y * p.y + p.z * p.z;
    const double s2 = m * m - (1 - inverse_distance_ * inverse_distance_) * p2;
    if (m <= 0 || s2 <= 0) return std::nullopt;
    const double s = std::sqrt(s2);
    const double q = m * m + p2 * inverse_distance_ * inverse_distance_;
    const double along = (p2 * inverse_distance_ + s * m) / q;
    const double across = (m - s * inverse_distance_) / q;
    const Vec3 start = {static_cast<float>(e.x * along + p.x * across), static_cast<float>(e.y * along + p.y * across),
                        static_cast<float>(e.z * along + p.z * across)};
    const Vec3 direction = {static_cast<float>(p.x * inverse_distance_ - m * e.x),
                            static_cast<float>(p.y * inverse_distance_ - m * e.y),
                            static_cast<float>(p.z * inverse_distance_ - m * e.z)};
    return Ray{start, normalized(direction)};
}

}  // namespace lumi::baker
