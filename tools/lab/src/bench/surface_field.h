// SPDX-License-Identifier: MIT
// The surface field that the bench draws: a file that the user names, or one baked from the bench's scene.
#pragma once

#include <filesystem>
#include <string>

#include "bench/measure.h"
#include "files/field_file.h"
#include "lumi/baker/surface.h"

namespace lumi::bench
{

// What `lumi bake product.obj --fit 250kB` plans, with fewer light paths: noise costs nothing to draw.
baker::SurfaceSettings surface_settings();

// Opens Settings::surface_file, or the field of the scene, which is baked now unless it lies in the work folder. Throws
// tools::Failure for a field that is not a surface field.
tools::FieldFile require_surface_field(const Settings& settings);

// Which file figures are of.
SurfaceFacts facts_of(const tools::FieldFile& file);

}  // namespace lumi::bench
