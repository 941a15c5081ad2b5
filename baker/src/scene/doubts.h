// SPDX-License-Identifier: MIT
// Finds things in a scene that its author can hardly mean.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene_data.h"

namespace lumi::baker
{

// Appends one line for each kind of doubt, with the mend: lamps inside closed bodies, nothing opaque, a part
// that makes all others tiny, faces of two materials in one place, open glass, coordinates that binary32 cannot hold.
// `origin` is that of the parts. Cost: a few passes over the triangles, and some ten thousand rays for each lamp that
// keeps all of its light inside a body.
void report_doubts(const SceneData& scene, const std::array<double, 3>& origin, const std::filesystem::path& file,
                   std::vector<std::string>& warnings);

}  // namespace lumi::baker
