// SPDX-License-Identifier: MIT
#include "guided/chart_geometry.h"

#include "lumi/guided/guided_format.h"

namespace lumi::baker
{
namespace
{

constexpr float kRoot3 = 1.7320508f;

}  // namespace

ChartGeometry::ChartGeometry(const Lattice& origins, uint32_t origin, uint32_t chart_size)
    : rays_(origins, origin),
      half_size_(static_cast<float>(chart_size) / 2),
      centre_(static_cast<float>(format::chart_centre(chart_size))),
      side_(2 * format::chart_centre(chart_size) + 1)
{
}

std::optional<Ray> ChartGeometry::ray(const Vec2& place) const
{
    const float b = (place.y - centre_) * kRoot3 / (2 * half_size_);
    const float a = (place.x - centre_) / half_size_ - b / kRoot3;
    if (a * a + b * b >= 1) {
        return std::nullopt;
    }
    return rays_.ray({a, b});
}

Vec2 ChartGeometry::place(const Vec3& x) const
{
    const Vec2 step = grid_step(rays_.place(normalized(x - rays_.origin())));
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
