// SPDX-License-Identifier: MIT
// Which triangles of a mesh can be seen from around.
#pragma once

#include "geometry/view_cap.h"
#include "mesh/mesh_tracer.h"
#include "util/job.h"

namespace lumi::baker
{

// Without the triangles that nobody outside can see: each gets many rays, in many directions, before it counts as
// such. Positions stay as they are.
Mesh seen_part(const MeshTracer& tracer, Job& job, const ViewCap& cap = {});

}  // namespace lumi::baker
