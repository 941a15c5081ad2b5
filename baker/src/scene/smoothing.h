// SPDX-License-Identifier: MIT
// Normals for faces that bring none but lie in a smoothing group.
#pragma once

#include "scene/obj_parser.h"

namespace lumi::baker
{

// Gives each corner without a normal, of a face in a smoothing group, the mean of the normals of that group's faces at
// the same vertex, weighted by area. Faces outside groups stay flat.
void smooth_normals(ObjContent& content);

}  // namespace lumi::baker
