// SPDX-License-Identifier: MIT
// What the readers of surface fields share, with see-through parts and without.
#pragma once

#include "field/sections.h"
#include "lumi/surface/field.h"

namespace lumi::detail
{

inline constexpr uint32_t kSurfaceSections[] = {
    format::kSurfaceSection, format::kVertexSection, format::kPatchSection,     format::kColourSection,
    format::kPaletteRgb,     format::kViewSection,   format::kNeighbourSection, format::kSeeThroughSection};
inline constexpr container::KnownTypes kOpaqueSections = {kSurfaceSections, 7};
inline constexpr container::KnownTypes kSeeThroughSections = {kSurfaceSections, 8};

// open_surface for a file that may have `known` sections.
FieldError open_mesh(const uint8_t* bytes, size_t size, container::KnownTypes known, SurfaceField& out);

// Whether there are neighbours for no triangle but those of the field's patches.
bool has_fitting_neighbours(const SurfaceField& field);

}  // namespace lumi::detail
