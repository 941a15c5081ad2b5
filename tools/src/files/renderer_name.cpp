// SPDX-License-Identifier: MIT
#include "files/renderer_name.h"

#include <algorithm>
#include <cctype>

#include "lumi/chord/render_spans.h"

namespace lumi::tools
{

namespace
{

std::string texel_policy(TexelFormat format)
{
    std::string name = detail::texel_name(format);
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return "lumi::Texel" + name;
}

// `drawing` lacks its last parameters and the closing bracket; an example has other ones.
RendererName named(const char* header, const char* opener, const char* parameters, const std::string& drawing,
                   const std::string& last, const std::string& last_of_example = "")
{
    return {header, opener, parameters, "lumi::View<" + drawing + ", " + last + ">, Screen>",
            "lumi::View<" + drawing + last_of_example + ">, lumi::Screen<240, 240, 16>>"};
}

RendererName renderer_of(const SeeThroughField& field)
{
    const uint32_t patches = std::max(field.patch_count, 1u);  // memory for none is no array
    const std::string drawing =
        "lumi::SurfaceDrawing<" + std::to_string(field.vertex_count) + ", " + std::to_string(patches);
    const std::string glass = field.see_through_count == 0 ? "" : ", " + std::to_string(field.see_through_count);
    const bool is_plain = field.see_through_count == 0 && field.viewed_count == 0;
    return named("lumi/surface/view.h", "open_surface", "lumi::SurfaceMode Finest = lumi::SurfaceMode::antialiased",
                 drawing, "Finest" + (is_plain ? ", 0, 0" : glass),
                 glass.empty() ? "" : ", lumi::SurfaceMode::antialiased" + glass);
}

}  // namespace

RendererName renderer_of(const FieldFile& field)
{
    if (field.is_surface()) return renderer_of(field.surface());
    const std::string drawing = fits_spans(field.field()) ? "ChordDrawing" : "ExactChordDrawing";
    return named("lumi/chord/view.h", "open_field", "class Reconstruction = lumi::Linear",
                 "lumi::" + drawing + "<" + texel_policy(field.field().texel_format), "Reconstruction");
}

}  // namespace lumi::tools
