// SPDX-License-Identifier: MIT
// What a user should know about a mesh that came out badly.
#pragma once

#include <string>
#include <vector>

#include "lumi/baker/mesh_loss.h"

namespace lumi::baker
{

// `asked` and `got` are triangles that can be seen; ask for no more than the scene has. Sentences for the user: what
// is wrong, and what mends it. `of_volume`: the mesh is a volume's shell.
std::vector<std::string> mesh_warnings(const MeshLoss& loss, size_t asked, size_t got, bool of_volume);

}  // namespace lumi::baker
