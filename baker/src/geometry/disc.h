// SPDX-License-Identifier: MIT
// A level disc: its normal is the up axis.
#pragma once

#include "math/vec3.h"

namespace lumi::baker
{

struct Disc {
    Vec3 centre;
    float radius;
};

}  // namespace lumi::baker
