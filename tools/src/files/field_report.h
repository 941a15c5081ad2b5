// SPDX-License-Identifier: MIT
// This is all that `lumi inspect` says about a field file.
#pragma once

#include <string>

#include "files/field_file.h"

namespace lumi::tools
{

uint32_t triangles_of(const SurfaceField& field);
std::string name_of_part(const SurfaceField& field, uint32_t part);
std::string name_of_state(const SurfaceField& field, uint32_t state);

// For people, and for programs; both end with a line break. If `verify`, each section's bytes are compared with its
// CRC.
std::string report_text(const FieldFile& file, bool verify);
std::string report_json(const FieldFile& file, bool verify);

// Names what draws a field, in the words of core's headers.

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
