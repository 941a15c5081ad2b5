// SPDX-License-Identifier: MIT
// Puts several scenes into one.
#pragma once

#include "model/scene_parts.h"
#include "util/json_text.h"
#include "volume/affine.h"

namespace lumi::baker
{

// Scales, then turns about the axes x, y, z of the scene in this order (degrees, counterclockwise when the axis points
// at the viewer), then moves.
struct Placement {
    Vec3 scale = {1, 1, 1};  // none is 0; negative ones mirror
    Vec3 rotation_degrees;
    Vec3 translation;
};

// Mirrored triangles turn their winding, so that outsides stay outsides.
// Takes the parts' origin back to 0.
void place(const Placement& placement, SceneParts& parts);
// Does the same for points.
Affine affine_of(const Placement& placement);

// Adds the second to the first: its mesh, materials and textures.
void append(SceneParts& parts, SceneParts&& other);

// Adds a disc of triangles.
void append_disc(SceneParts& parts, const Disc& disc, UpAxis up, const Material& material);

// Throws SceneError.
Placement read_placement(JsonMembers& members);

}  // namespace lumi::baker
