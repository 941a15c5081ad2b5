// SPDX-License-Identifier: MIT
// Surface fields on the bench: what whole frames of one file cost, part by part, and how exact they are.
#pragma once

#include "bench/measure.h"
#include "lumi/bench/surface_modes.h"

namespace lumi::bench
{

// The names of kSurfaceModes.
std::vector<std::string> surface_mode_names();
// Whether a mode draws surface fields.
bool is_surface(const std::string& mode);
// Precondition: is_surface(mode).
SurfaceMode surface_mode(const std::string& mode);

// One result per core, mode, kind of pixel and view of the matrix, in this order; none, and nothing is baked, where the
// matrix has no mode of surface fields. Throws as measure() does.
SurfaceResults measure_surface(const Settings& settings, const Announce& announce);

}  // namespace lumi::bench
