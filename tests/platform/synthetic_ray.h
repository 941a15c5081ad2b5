// SPDX-License-Identifier: MIT
// A scene in closed form: a chequered ball of half the sphere's radius with a half-transparent rim. Every texel is
// known at once, so that tests of the renderer on boards need no path tracing.
#pragma once

#include "lumi/color.h"
#include "lumi/detail/lattice.h"

namespace lumi::test
{

// Returns what the ray from `origin` to `target` on the unit sphere sees: premultiplied colour with coverage.
detail::Rgba8 synthetic_ray(const Vec3q30& origin, const Vec3q30& target);

}  // namespace lumi::test
