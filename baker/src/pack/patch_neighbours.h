// SPDX-License-Identifier: MIT
// Which triangles lie across the sides of patches, and which of these sides are creases.
#pragma once

#include <array>
#include <vector>

#include "pack/surface_writer.h"

namespace lumi::baker
{

// Whether a see-through patch is a shadow.
bool is_shadow(const PatchMesh& mesh, uint32_t patch);

// By patch, the words of lumi/surface/format.h. Neighbours have one owner: the body, a part, or the see-through
// patches. A shadow fades to nothing: its border counts as its own neighbour, so that no outline is drawn there.
std::vector<std::array<uint16_t, 4>> patch_neighbours(const FitShape& shape, const FieldParts& parts);

}  // namespace lumi::baker
