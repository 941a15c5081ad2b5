// SPDX-License-Identifier: MIT
// The environment is a light: radiance is linear in the height of the direction, or a picture.
//
// The first is sampled by its brightness, a picture by how much it is brighter than its mean. So samples of a picture
// do not find all of its light: who draws them also sends rays by his own density, and weighs both (power_weight()).
// Broad dim light is found by such rays, with less noise. Karlík et al., "MIS Compensation: Optimizing Sampling
// Techniques in Multiple Importance Sampling", ACM TOG 38(6), 2019, section 5.
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

// A direction shows this radiance of the sky, and samples of the sky go there with this density in solid angle.
struct SkyLight {
    Rgb radiance;
    float pdf;
};

// A picture of all directions as a light.
//
// Latitude-longitude map: the top row is the zenith, the middle column lies at azimuth 0 (the sphere's +x), and columns
// to its right at smaller azimuths, as seen from inside. Between pixel centres the radiance is bilinear.

class SkyPicture
{
public:
    // turns: how far the picture is turned counterclockwise, seen from above.
    SkyPicture(std::shared_ptr<const RadiancePicture> picture, float turns, float scale);

    SkyLight at(const Vec3& direction) const;
    // Density 0 where nothing is brighter than the mean.
    LightSample sample(const Vec2& u) const;
    // Returns the brightness, summed over all directions.
    float brightness_sum() const { return brightness_sum_; }
    void add_to(Digest& digest) const;  // all that decides its light

private:
    // In pixels, (0,0) is the picture's upper left corner.
    Vec2 place_of(const Vec3& direction) const;
    Rgb radiance(const Vec2& place) const;
    float pdf(size_t x, size_t y, float sine) const;  // of a pixel, sine of the angle from the zenith

    std::shared_ptr<const RadiancePicture> picture_;
    float turns_, scale_, brightness_sum_ = 0;
    // By how much a pixel is brighter than the mean. Empty for an even sky.
    Distribution rows_;
    std::vector<Distribution> columns_;  // one a row
};

class Sky : public Light
{
public:
    explicit Sky(const Environment& environment);

    SkyLight at(const Vec3& direction) const;

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
