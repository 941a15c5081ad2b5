// SPDX-License-Identifier: MIT
// Puts shadows into a field: that of the ground, and those of moving parts.
#pragma once

#include "pack/surface_writer.h"
#include "shadow/ground_shadow.h"
#include "shadow/part_shadows.h"

namespace lumi::baker
{

// Entries of the see-through palette that a shadow on the ground takes beside what else is see-through.
size_t ground_levels(const GroundShadow& shadow, const PatchMesh& mesh);

// Adds see-through patches before those that there are: nothing that one sees from above the ground lies behind it.
// Says why there is none, a sentence each.
std::vector<std::string> add_ground(const GroundShadow& shadow, FitShape& shape, FieldParts& parts);

// The most vertices, patches and bytes that they take.
struct GroundRoom {
    uint32_t vertices, patches;
    uint64_t bytes;
};
GroundRoom most_ground_room(float longest_edge, float texels_per_radius);

// Adds see-through patches that follow their parts. Precondition: the shape has none yet but the ground's. Leaves those
// out for which the format has no room, and says so, a sentence each.
std::vector<std::string> add_shadows(const std::vector<PartShadow>& shadows, FitShape& shape, FieldParts& parts);

// The most bytes that they take of a field with so many parts and, without them, so many texels.
uint64_t most_shadow_bytes(size_t parts, uint32_t texels);

}  // namespace lumi::baker
