// SPDX-License-Identifier: MIT
// Pictures by the double-precision twin of the guided renderer.
#pragma once

#include "draw/views.h"
#include "lumi/guided/guided_field.h"
#include "lumi/reference/guided_picture.h"

namespace lumi::quality
{

tools::Picture draw_twin(const GuidedField& field, const tools::Eye& eye, const reference::GuidedDrawing& drawing,
                         const Rgb8& background);

}  // namespace lumi::quality
