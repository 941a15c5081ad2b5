// SPDX-License-Identifier: MIT
#include "files/renderer_name.h"

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

// `drawing` lacks its last parameter and the closing bracket.
RendererName named(const char* header, const char* opener, const char* parameters, const std::string& drawing,
                   const char* last)
{
    return {header, opener, parameters, "lumi::View<" + drawing + ", " + last + ">, Screen>",
            "lumi::View<" + drawing + ">, lumi::Screen<240, 240, 16>>"};
}

}  // namespace

RendererName renderer_of(const FieldFile& field)
{
    if (field.is_surface()) {
        const SurfaceField& surface = field.surface();
        return named(
            "lumi/surface/view.h", "open_surface", "lumi::SurfaceMode Finest = lumi::SurfaceMode::antialiased",
            "lumi::SurfaceDrawing<" + std::to_string(surface.vertex_count) + ", " + std::to_string(surface.patch_count),
            "Finest");
    }
    const std::string drawing = fits_spans(field.field()) ? "ChordDrawing" : "ExactChordDrawing";
    return named("lumi/chord/view.h", "open_field", "class Reconstruction = lumi::Linear",
                 "lumi::" + drawing + "<" + texel_policy(field.field().texel_format), "Reconstruction");
}

}  // namespace lumi::tools
