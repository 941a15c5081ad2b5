// SPDX-License-Identifier: MIT
// The options of `lumi bake` for surface fields.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "lumi/baker/surface.h"

namespace lumi::tools
{

// Adds what only surface fields have; `settings` must outlive the parse.
void add_surface_options(CLI::App& command, baker::SurfaceSettings& settings);

// What the mesh of a field is and gets wrong, a line.
std::string surface_text(const baker::SurfaceBake& bake);
nlohmann::json surface_json(const baker::SurfaceBake& bake);

}  // namespace lumi::tools
