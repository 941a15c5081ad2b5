// SPDX-License-Identifier: MIT
// Which triangles of a mesh can be seen from around.
#pragma once

#include "geometry/view_cap.h"
#include "mesh/mesh_tracer.h"
#include "util/job.h"

namespace lumi::baker
{

// A triangle that none of so many rays meets counts as hidden. Where both of its sides count, each gets half of them.
inline constexpr uint32_t kSeenRays = 2048;

// The tracer's mesh without the triangles that nobody outside can see: each gets `rays`, in many directions, before it
// counts as such. Positions stay as they are. Where rays meet both faces, each side that is seen becomes a triangle
// that faces that way, so that the two can have colours of their own. The result is always a mesh of front faces.
Mesh seen_part(const MeshTracer& tracer, Job& job, const ViewCap& cap = {}, uint32_t rays = kSeenRays);

}  // namespace lumi::baker
