// SPDX-License-Identifier: MIT
// A cube with faces of three colours, two of them glossy, in a gradient of light, and its surface field: baked in a
// second, a few kilobytes.
#pragma once

#include <string>
#include <vector>

#include "lumi/baker/scene.h"
#include "lumi/baker/surface.h"

namespace lumi::tools::test
{

// Writes cube.obj and cube.mtl into the folder; returns the path of the first.
std::string write_cube(const std::string& folder);

// The options of `lumi bake` for small_surface().
std::vector<std::string> small_surface_options();

const baker::Scene& cube_scene();
const baker::SurfaceBake& small_surface();  // baked once
std::string small_surface_bytes();
std::string glossy_surface_bytes();  // the cube in the studio, with gloss maps; baked anew

}  // namespace lumi::tools::test
