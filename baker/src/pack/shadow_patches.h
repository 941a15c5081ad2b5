// SPDX-License-Identifier: MIT
// Puts the shadows of moving parts into a field.
#pragma once

#include "fit/part_shadows.h"
#include "pack/surface_writer.h"

namespace lumi::baker
{

// Adds see-through patches that follow their parts. Precondition: the shape has none yet. Leaves those out for which
// the format has no room, and says so, a sentence each.
std::vector<std::string> add_shadows(const std::vector<PartShadow>& shadows, FitShape& shape, FieldParts& parts);

// The most bytes that they take of a field with so many parts.
uint64_t most_shadow_bytes(size_t parts);

}  // namespace lumi::baker
