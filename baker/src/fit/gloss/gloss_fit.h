// SPDX-License-Identifier: MIT
// Finds the gloss maps of a field, if they pay.
//
// Texels, view tables and maps are unknowns of one least-squares problem over lines to smooth surfaces: maps that are
// fitted to what tables leave gain nothing, since tables take the blurred part of a highlight (docs/log/surface.md).
// Texels are eliminated, and conjugate gradients solve the rest. Each map becomes one colour times bytes. The field's
// own fit has the maps as they are, and finds texels and tables for the rest of the light.
#pragma once

#include "fit/fit_shape.h"
#include "store/bake_stages.h"
#include "util/job.h"

namespace lumi::baker
{

// Whether maps may pay: smooth surfaces could mirror light with edges (a sky that is a picture, or lamps), and
// settings, light states or a volume do not rule maps out.
bool may_gloss(const SceneData& scene, const PatchMesh& mesh, const SurfaceSettings& settings);

// Nothing where maps take too little of what a field without them is off. A bake that is killed meanwhile goes on from
// what `stages` kept.
Gloss gloss_of(const SceneData& scene, const FitShape& shape, const SurfaceSettings& settings, BakeStages& stages,
               const ProgressCallback& progress);

}  // namespace lumi::baker
