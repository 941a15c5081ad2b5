// SPDX-License-Identifier: MIT
// The reconstruction of guided_format.h in double precision: what a guided field shows of a surface point.
#pragma once

#include "lumi/guided/guided_field.h"
#include "lumi/reference/picture.h"

namespace lumi::reference
{

enum class Origins : uint8_t { three, heaviest };
enum class Taps : uint8_t { linear, nearest };

struct GuidedShading {
    Origins origins = Origins::three;
    Taps taps = Taps::linear;
};

// Where X lies in an origin's chart, in grid points.
struct ChartPlace {
    double u, v;
};
ChartPlace chart_place(const GuidedField& field, uint32_t origin, const Vec3& x);

// Trilinear between the nodes around X. Precondition: the field has a mean section.
Colour mean_colour(const GuidedField& field, const Vec3& x);

// Whether the occlusion section says that X is hidden from the origin.
bool is_hidden(const GuidedField& field, uint32_t origin, const Vec3& x);

// The colour of X and how much of it the field knows, 0 or 1; on a focus surface without mean anything between.
struct Shade {
    Colour colour;
    double coverage;
};

// `weights` are those of the origin triangle around the pixel's front hit.
Shade shade(const GuidedField& field, const Weights& weights, const Vec3& x, const GuidedShading& shading);

}  // namespace lumi::reference
