// SPDX-License-Identifier: MIT
// A picture of all directions as a light.
//
// Latitude-longitude map: the top row is the zenith, the middle column lies at azimuth 0 (the sphere's +x), and columns
// to its right at smaller azimuths, as seen from inside. Between pixel centres the radiance is bilinear.
#pragma once

#include <memory>

#include "image/radiance_picture.h"
#include "math/distribution.h"
#include "util/digest.h"

namespace lumi::baker
{

class SkyPicture
{
public:
    // turns: how far the picture is turned counterclockwise, seen from above.
    SkyPicture(std::shared_ptr<const RadiancePicture> picture, float turns, float scale);

    Rgb radiance(const Vec3& direction) const;
    float pdf(const Vec3& direction) const;  // solid angle
    Vec3 sample(const Vec2& u) const;        // proportional to the brightness of pixels
    // The brightness, summed over all directions.
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

}  // namespace lumi::baker
