// SPDX-License-Identifier: MIT
#include "light/sky.h"

namespace lumi::baker
{
namespace
{

Rgb to_rgb(const std::array<float, 3>& c)
{
    return {c[0], c[1], c[2]};
}

// x in [0,1] with density proportional to a(1-x) + bx; a + b > 0.
float sample_linear(float a, float b, float u)
{
    const float root = std::sqrt((1 - u) * a * a + u * b * b);
    return std::min(u * (a + b) / (a + root), 1.0f);
}

std::optional<SkyPicture> picture_of(const Environment& environment)
{
    if (!environment.picture) return std::nullopt;
    return SkyPicture(environment.picture, environment.rotation_degrees / 360, environment.scale);
}

}  // namespace

Sky::Sky(const Environment& environment)
    : picture_(picture_of(environment)),
      zenith_(to_rgb(environment.zenith) * environment.scale),
      horizon_(to_rgb(environment.horizon) * environment.scale),
      nadir_(to_rgb(environment.nadir) * environment.scale),
      top_(max_component(zenith_)),
      middle_(max_component(horizon_)),
      bottom_(max_component(nadir_)),
      upper_mass_(0.5f * (top_ + middle_)),
      lower_mass_(0.5f * (bottom_ + middle_))
{
}

Rgb Sky::radiance(const Vec3& direction) const
{
    if (picture_) return picture_->radiance(direction);
    const float z = std::clamp(direction.z, -1.0f, 1.0f);
    const Rgb& pole = z > 0 ? zenith_ : nadir_;
    return horizon_ * (1 - std::abs(z)) + pole * std::abs(z);
}

float Sky::brightness(float height) const
{
    const float pole = height > 0 ? top_ : bottom_;
    return middle_ * (1 - std::abs(height)) + pole * std::abs(height);
}

float Sky::pdf(const Vec3& direction) const
{
    if (picture_) return picture_->pdf(direction);
    return brightness(std::clamp(direction.z, -1.0f, 1.0f)) / (2 * kPi * (upper_mass_ + lower_mass_));
}

float Sky::power() const
{
    // Radiance over all directions, through the unit sphere's disc.
    return kPi * (picture_ ? picture_->brightness_sum() : 2 * kPi * (upper_mass_ + lower_mass_));
}

LightSample Sky::sample(const Vec3&, float u_select, const Vec2& u) const
{
    constexpr float kEverywhere = std::numeric_limits<float>::infinity();
    if (picture_) {
        const Vec3 direction = picture_->sample(u);
        return {direction, kEverywhere, picture_->radiance(direction), picture_->pdf(direction)};
    }
    const bool upper = u_select * (upper_mass_ + lower_mass_) < upper_mass_;
    const float height = sample_linear(middle_, upper ? top_ : bottom_, u.x);
    const Vec3 direction = direction_at(upper ? height : -height, u.y);
    return {direction, kEverywhere, radiance(direction), pdf(direction)};
}

void Sky::add_to(Digest& digest) const
{
    for (const Rgb& colour : {zenith_, horizon_, nadir_}) digest.add(colour);
    digest.add(picture_.has_value());
    if (picture_) picture_->add_to(digest);
}

}  // namespace lumi::baker
