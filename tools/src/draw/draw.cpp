// SPDX-License-Identifier: MIT
#include "draw/draw.h"

#include <cassert>

#include "lumi/chord/render_spans.h"

namespace lumi::tools
{

const char* name_of(Mode mode)
{
    constexpr const char* kNames[] = {"nearest", "linear", "paper"};
    return kNames[static_cast<size_t>(mode)];
}

// Instantiated for each format from span_stripes.cpp.in.
template <class Texel>
Picture draw_texels(const Field& field, const Camera& camera, const DrawSettings& settings);

Picture draw(const Field& field, const Camera& camera, const DrawSettings& settings)
{
    assert(settings.neighbours >= 1 && settings.neighbours <= detail::kMaxNeighbours);
    return detail::with_texel(field.texel_format,
                              [&](auto texel) { return draw_texels<decltype(texel)>(field, camera, settings); });
}

}  // namespace lumi::tools
