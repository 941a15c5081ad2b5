// SPDX-License-Identifier: MIT
// The environment as a light: radiance linear in the height of the direction, or a picture; sampled by its brightness.
#pragma once

#include <optional>

#include "light/light.h"
#include "light/sky_picture.h"
#include "lumi/baker/scene.h"
#include "math/warp.h"

namespace lumi::baker
{

class Sky : public Light
{
public:
    explicit Sky(const Environment& environment);

    Rgb radiance(const Vec3& direction) const;
    float pdf(const Vec3& direction) const;  // solid angle

    float power() const override;
    LightSample sample(const Vec3& from, float u_select, const Vec2& u) const override;
    void add_to(Digest& digest) const;  // all that decides its light

private:
    float brightness(float height) const;

    std::optional<SkyPicture> picture_;
    // Without a picture:
    Rgb zenith_, horizon_, nadir_;
    float top_, middle_, bottom_;    // brightness at heights 1, 0, -1
    float upper_mass_, lower_mass_;  // integrals of the brightness over height
};

}  // namespace lumi::baker
