// SPDX-License-Identifier: MIT
#include "files/renderer_name.h"

#include <cctype>

#include "lumi/render_spans.h"

namespace lumi::tools
{

namespace
{

std::string texel_policy(format::TexelFormat format)
{
    std::string name = texel_name(format);
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return "lumi::Texel" + name;
}

}  // namespace

RendererName renderer_of(const FieldFile& field)
{
    if (field.is_surface()) {
        const SurfaceField& surface = field.surface();
        const std::string counts = std::to_string(surface.vertex_count) + ", " + std::to_string(surface.patch_count);
        return {"lumi/surface_view.h", "open_surface", "lumi::SurfaceMode Finest = lumi::SurfaceMode::antialiased",
                "lumi::View<lumi::SurfaceDrawing<" + counts + ", Finest>, Screen>"};
    }
    const std::string drawing = fits_spans(field.field()) ? "ChordDrawing" : "ExactChordDrawing";
    return {
        "lumi/chord_view.h", "open_field", "class Reconstruction = lumi::Linear",
        "lumi::View<lumi::" + drawing + "<" + texel_policy(field.field().texel_format) + ", Reconstruction>, Screen>"};
}

}  // namespace lumi::tools
