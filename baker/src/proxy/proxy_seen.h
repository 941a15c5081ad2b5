// SPDX-License-Identifier: MIT
// Which triangles of a proxy can be seen from around.
#pragma once

#include "geometry/mesh.h"
#include "scene/scene_data.h"
#include "util/job.h"

namespace lumi::baker
{

// Without the triangles that no ray from around sees. Positions stay as they are.
Mesh seen_part(const SceneData& scene, const Mesh& mesh, bool two_sided, Job& job);

}  // namespace lumi::baker
