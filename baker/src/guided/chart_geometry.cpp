// SPDX-License-Identifier: MIT
#include "guided/chart_geometry.h"

#include "lumi/guided_chart.h"
#include "lumi/guided_format.h"

namespace lumi::baker
{
namespace
{

constexpr float kRoot3 = 1.7320508f;

Vec3 from_q14(const int16_t (&v)[3])
{
    constexpr float kUnit = 1.0f / 16384;
    return {v[0] * kUnit, v[1] * kUnit, v[2] * kUnit};
}

Vec3 from_q30(const Vec3q30& p)
{
    constexpr double kUnit = 1.0 / kOneQ30;
    return normalized(
        {static_cast<float>(p.x * kUnit), static_cast<float>(p.y * kUnit), static_cast<float>(p.z * kUnit)});
}

}  // namespace

ChartGeometry::ChartGeometry(const Lattice& origins, uint32_t origin, uint32_t chart_size)
    : p_(from_q30(point(origins, origin))),
      half_size_(static_cast<float>(chart_size) / 2),
      centre_(static_cast<float>(format::chart_centre(chart_size))),
      side_(2 * format::chart_centre(chart_size) + 1)
{
    const ChartFrame frame = chart_frame(point(origins, origin));
    tangent_ = from_q14(frame.tangent_q14);
    bitangent_ = from_q14(frame.bitangent_q14);
}

Ray ChartGeometry::ray_in_disc(const Vec2& ab) const
{
    const float inwards = std::sqrt(std::max(0.0f, 1 - ab.x * ab.x - ab.y * ab.y));
    return {p_, normalized(tangent_ * ab.x + bitangent_ * ab.y - p_ * inwards)};
}

std::optional<Ray> ChartGeometry::ray(const Vec2& place) const
{
    const float b = (place.y - centre_) * kRoot3 / (2 * half_size_);
    const float a = (place.x - centre_) / half_size_ - b / kRoot3;
    if (a * a + b * b >= 1) {
        return std::nullopt;
    }
    return ray_in_disc({a, b});
}

Vec2 ChartGeometry::place(const Vec3& x) const
{
    const Vec3 e = normalized(x - p_);
    const Vec2 step = grid_step({dot(tangent_, e), dot(bitangent_, e)});
    return {centre_ + step.x, centre_ + step.y};
}

Vec2 ChartGeometry::grid_step(const Vec2& ab) const
{
    return {(ab.x + ab.y / kRoot3) * half_size_, 2 * ab.y / kRoot3 * half_size_};
}

float ChartGeometry::cell_radius() const
{
    // A cell's area is √3/2 of the square of the grid's step, 1/half_size.
    return std::sqrt(kRoot3 / 2 / kPi) / half_size_;
}

}  // namespace lumi::baker
