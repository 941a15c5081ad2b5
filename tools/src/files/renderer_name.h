// SPDX-License-Identifier: MIT
// Names what draws a field, in the words of core's headers.
#pragma once

#include <string>

#include "files/field_file.h"

namespace lumi::tools
{

// How a C++ program names the view of a field.
struct RendererName {
    std::string header;      // "lumi/surface/view.h"
    std::string opener;      // "open_surface"
    std::string parameters;  // parameters of the template alias, where a program writes the screen
    std::string view;        // "lumi::View<lumi::SurfaceDrawing<2500, 2400, Finest>, Screen>"
    std::string example;     // "lumi::View<lumi::SurfaceDrawing<2500, 2400>, lumi::Screen<240, 240, 16>>"
};

RendererName renderer_of(const FieldFile& field);

}  // namespace lumi::tools
