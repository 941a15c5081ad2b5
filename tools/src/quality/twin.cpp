// SPDX-License-Identifier: MIT
#include "quality/twin.h"

#include <cmath>

namespace lumi::quality
{

tools::Picture draw_twin(const GuidedField& field, const tools::Eye& eye, const reference::GuidedDrawing& drawing,
                         const Rgb8& background)
{
    const reference::GuidedPicture drawn = reference::draw_guided(field, eye.pose, eye.image, drawing, background);
    tools::Picture picture(drawn.width_px, drawn.height_px);
    for (size_t i = 0; i < drawn.colours.size(); ++i) {
        const double rgb[3] = {drawn.colours[i].r, drawn.colours[i].g, drawn.colours[i].b};
        for (size_t k = 0; k < 3; ++k) picture.rgb[3 * i + k] = static_cast<uint8_t>(std::lround(rgb[k]));
    }
    return picture;
}

}  // namespace lumi::quality
