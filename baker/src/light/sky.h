// SPDX-License-Identifier: MIT
// The environment is a light: radiance is linear in the height of the direction, or a picture; it is sampled by its
// brightness.
#pragma once

#include <memory>
#include <optional>

#include "image/radiance_picture.h"
#include "light/light.h"
#include "lumi/baker/scene.h"
#include "math/distribution.h"
#include "math/warp.h"
#include "util/digest.h"

namespace lumi::baker
{

// A picture of all directions as a light.
//
// Latitude-longitude map: the top row is the zenith, the middle column lies at azimuth 0 (the sphere's +x), and columns
// to its right at smaller azimuths, as seen from inside. Between pixel centres the radiance is bilinear.

class SkyPicture
{
public:
    // turns: how far the picture is turned counterclockwise, seen from above.
    SkyPicture(std::shared_ptr<const RadiancePicture> picture, float turns, float scale);

    Rgb radiance(const Vec3& direction) const;
    float pdf(const Vec3& direction) const;  // solid angle
    Vec3 sample(const Vec2& u) const;        // proportional to the brightness of pixels
    // Returns the brightness, summed over all directions.
    float brightness_sum() const { return static_cast<float>(rows_.total()); }
    void add_to(Digest& digest) const;  // all that decides its light

private:
    // In pixels, (0,0) is the picture's upper left corner.
    Vec2 place_of(const Vec3& direction) const;
    Vec3 direction_of(const Vec2& place) const;

    std::shared_ptr<const RadiancePicture> picture_;
    float turns_, scale_;
    Distribution rows_;
    std::vector<Distribution> columns_;  // one a row
};

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
    // These serve skies without a picture:
    Rgb zenith_, horizon_, nadir_;
    float top_, middle_, bottom_;    // brightness at heights 1, 0, -1
    float upper_mass_, lower_mass_;  // integrals of the brightness over height
};

}  // namespace lumi::baker
