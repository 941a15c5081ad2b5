// SPDX-License-Identifier: MIT
#include "image/plane.h"

namespace lumi::tools
{

Plane<double> luma_plane(const Picture& picture)
{
    constexpr double kRed = 0.299, kGreen = 0.587, kBlue = 0.114;
    Plane<double> plane(picture.width_px, picture.height_px);
    for (size_t i = 0; i < plane.values.size(); ++i) {
        const uint8_t* rgb = &picture.rgb[3 * i];
        plane.values[i] = kRed * rgb[0] + kGreen * rgb[1] + kBlue * rgb[2];
    }
    return plane;
}

}  // namespace lumi::tools
