// SPDX-License-Identifier: MIT
#include "draw/draw.h"

#include <cassert>
#include <stdexcept>

#include "lumi/render_spans.h"

namespace lumi::tools
{

// Each format is instantiated in span_stripes_*.cpp.
template <class Texel>
Picture draw_texels(const Field& field, const Camera& camera, const DrawSettings& settings);
extern template Picture draw_texels<TexelRgb888>(const Field&, const Camera&, const DrawSettings&);
extern template Picture draw_texels<TexelRgb565>(const Field&, const Camera&, const DrawSettings&);
extern template Picture draw_texels<TexelPalette8>(const Field&, const Camera&, const DrawSettings&);
extern template Picture draw_texels<TexelLuma8>(const Field&, const Camera&, const DrawSettings&);

Picture draw(const Field& field, const Camera& camera, const DrawSettings& settings)
{
    assert(settings.neighbours >= 1 && settings.neighbours <= kMaxNeighbours);
    switch (field.texel_format) {
        case format::TexelFormat::rgb888:
            return draw_texels<TexelRgb888>(field, camera, settings);
        case format::TexelFormat::rgb565:
            return draw_texels<TexelRgb565>(field, camera, settings);
        case format::TexelFormat::palette8:
            return draw_texels<TexelPalette8>(field, camera, settings);
        case format::TexelFormat::luma8:
            return draw_texels<TexelLuma8>(field, camera, settings);
    }
    throw std::logic_error("open_field let an unknown texel format pass");
}

}  // namespace lumi::tools
