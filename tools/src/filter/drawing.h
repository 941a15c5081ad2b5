// SPDX-License-Identifier: MIT
// A filter is given drawings of a view, and returns another picture of it.
#pragma once

#include "draw/views.h"
#include "files/field_file.h"
#include "filter/network.h"
#include "quality/references.h"

namespace lumi::filter
{

// kPicturePlanes or kSurfacePlanes, as the field's kind has.
uint32_t input_planes(const tools::FieldFile& field);

// The view as the best mode draws it, over nothing, and of a surface field what else its renderer knows. Cost: two
// drawings of the picture, and of a surface field two cheap ones more. Leaves by Interrupted between stripes.
Planes drawn_planes(const tools::FieldFile& field, const tools::Eye& eye);

// Makes such planes of a path-traced reference over black.
Planes reference_planes(const quality::Reference& reference);

// Returns the first kPicturePlanes over a background, black unless told otherwise.
tools::Picture over(const Planes& planes, const Rgb8& background = {0, 0, 0});

}  // namespace lumi::filter
