// SPDX-License-Identifier: MIT
#include "quality/twin.h"

#include <cmath>

#include "lumi/twin/surface_picture.h"

namespace lumi::quality
{

tools::Picture draw_twin(const uint8_t* file, const tools::Eye& eye, SurfaceMode mode, const Rgb8& background)
{
    const twin::SurfaceDrawing drawing = {mode == SurfaceMode::one_sample ? 1 : 2};
    const twin::SurfacePicture drawn = twin::draw_surface(file, eye.pose, eye.image, drawing, background);
    tools::Picture picture(drawn.width_px, drawn.height_px);
    for (size_t i = 0; i < drawn.colours.size(); ++i) {
        const double rgb[3] = {drawn.colours[i].r, drawn.colours[i].g, drawn.colours[i].b};
        for (size_t k = 0; k < 3; ++k) picture.rgb[3 * i + k] = static_cast<uint8_t>(std::lround(rgb[k]));
    }
    return picture;
}

}  // namespace lumi::quality
