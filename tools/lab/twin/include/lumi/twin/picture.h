// SPDX-License-Identifier: MIT
// The renderer in double precision: hits by the plain quadratic equation, colours by sums that are never rounded.
#pragma once

#include "lumi/chord/field.h"
#include "lumi/color.h"
#include "lumi/twin/weights.h"

namespace lumi::twin
{

// Values are encoded, 0 .. 255.
struct Colour {
    double r = 0, g = 0, b = 0;
};

struct Hits {
    Vec3 front, back;
};

// Where the ray through the centre of pixel (x, y) enters and leaves the unit sphere. Precondition: it meets it.
Hits hits_of_pixel(const Pose& pose, const Image& image, int32_t x, int32_t y);

// The colour that the field shows for these taps over a background; origins outside the cap count as misses.
Colour blended(const Field& field, const Weights& origins, const Weights& directions, const Rgb8& background);

}  // namespace lumi::twin
