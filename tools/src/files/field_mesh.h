// SPDX-License-Identifier: MIT
// The mesh of a surface field as a text that other programs read.
#pragma once

#include <string>

#include "files/field_file.h"
#include "lumi/baker/scene.h"

namespace lumi::tools
{

// An OBJ file: vertices in the scene's units and axes, of which `up` is the vertical one; the triangles
// counter-clockwise seen from outside, in a group opaque and, where there are some, a group see_through. Throws Failure
// for a chord field, which has no mesh.
std::string obj_of(const FieldFile& file, baker::UpAxis up);

}  // namespace lumi::tools
