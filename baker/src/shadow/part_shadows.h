// SPDX-License-Identifier: MIT
// The shadow of a moving part on a flat receiver that its axis is perpendicular to, as a hand's on a dial.
//
// A part's light is baked without its shadow, for that would stay where it was. The shadow is a flat piece that lets a
// share of the light behind it pass and turns with the part, about an axis that is shifted to where the light throws
// it. It is the mean over poses of what the part takes away there.
#pragma once

#include <algorithm>

#include "fit/fit_shape.h"
#include "image/tone.h"
#include "lumi/baker/surface.h"
#include "lumi/surface/format.h"
#include "mesh/patch_mesh.h"

namespace lumi::baker
{

// A shadow has no more texels than a share of its field's.
inline constexpr uint32_t kFewestShadowTexels = 16;
inline uint32_t most_shadow_texels(uint32_t texels_of_field)
{
    return std::max(kFewestShadowTexels, texels_of_field / 32);
}

struct PartShadow {
    uint32_t part = 0;          // of the mesh's parts
    Vec3 pivot;                 // a point of the shifted axis
    Vec3 corner, across, down;  // a rectangle, in the pose of the mesh: its first corner, and its sides from there
    uint32_t columns = 0, rows = 0;
    std::vector<uint8_t> passed;  // by texel, row after row: the share of the levels behind, 0 .. 255
};

template <class Io>
void fields(Io& io, PartShadow& s)
{
    io(s.part, s.pivot, s.corner, s.across, s.down, s.columns, s.rows, s.passed);
    constexpr uint32_t kMost = detail::format::kMaxPatchSide;
    io.require(s.passed.size() == size_t{s.columns} * s.rows && s.columns <= kMost && s.rows <= kMost &&
               !s.passed.empty());
}

struct PartShadows {
    std::vector<PartShadow> shadows;
    std::vector<std::string> notes;  // why a part has none, a sentence each
};

template <class Io>
void fields(Io& io, PartShadows& s)
{
    io(s.shadows, s.notes);
}

// Those that can be told so: the receiver is flat, and the shadow looks alike in all poses. None where the mesh has
// see-through patches, whose colours take the palette.
PartShadows part_shadows(const SceneData& scene, const PatchMesh& mesh, const SurfaceSettings& settings,
                         const ProgressCallback& progress);

}  // namespace lumi::baker
