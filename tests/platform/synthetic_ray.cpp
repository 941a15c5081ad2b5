// SPDX-License-Identifier: MIT
#include "synthetic_ray.h"

#include <cmath>

namespace lumi::test
{
namespace
{

constexpr double kBallRadius = 0.6;
constexpr double kSolidRadius = 0.5;  // rays that pass further out see the half-transparent rim
constexpr int kChequersPerRadius = 4;
constexpr uint8_t kRimCoverage = 128;

struct Vec3 {
    double x, y, z;
};

Vec3 from_q30(const Vec3q30& v)
{
    return {static_cast<double>(v.x) / kOneQ30, static_cast<double>(v.y) / kOneQ30, static_cast<double>(v.z) / kOneQ30};
}

double dot(const Vec3& a, const Vec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vec3 along(const Vec3& start, const Vec3& step, double t)
{
    return {start.x + t * step.x, start.y + t * step.y, start.z + t * step.z};
}

// Position as colour, darkened on every other cube of a chequerboard; black occurs.
detail::Rgba8 shade(const Vec3& hit, uint8_t coverage)
{
    const auto cell = [](double v) { return static_cast<int>(std::floor(v * kChequersPerRadius)); };
    const bool dark = ((cell(hit.x) + cell(hit.y) + cell(hit.z)) & 1) != 0;
    const double scale = (dark ? 0.0 : 1.0) * coverage;
    const auto channel = [&](double v) { return static_cast<uint8_t>((v / kBallRadius + 1) / 2 * scale); };
    return {channel(hit.x), channel(hit.y), channel(hit.z), coverage};
}

}  // namespace

detail::Rgba8 synthetic_ray(const Vec3q30& origin, const Vec3q30& target)
{
    const Vec3 start = from_q30(origin);
    const Vec3 end = from_q30(target);
    const Vec3 step = {end.x - start.x, end.y - start.y, end.z - start.z};
    const double length2 = dot(step, step);
    const double middle = -dot(start, step) / length2;  // both ends lie on the unit sphere: 1/2, but for rounding
    const Vec3 closest = along(start, step, middle);
    const double closest2 = dot(closest, closest);
    if (!(length2 > 0) || closest2 > kBallRadius * kBallRadius) return {};
    const double half_chord = std::sqrt((kBallRadius * kBallRadius - closest2) / length2);
    const bool solid = closest2 <= kSolidRadius * kSolidRadius;
    return shade(along(start, step, middle - half_chord), solid ? 255 : kRimCoverage);
}

}  // namespace lumi::test
