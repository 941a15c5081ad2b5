// SPDX-License-Identifier: MIT
// Which layout shows more of a scene: both are baked with few light paths, and measured.
#pragma once

#include "lumi/baker/chord.h"
#include "lumi/baker/surface.h"

namespace lumi::tools
{

struct LayoutTrial {
    double surface_db, chord_db;  // as quality::quick_psnr_db says
};

// Takes seconds, and disk for a field of each layout while it lasts. Throws BakeError, Failure, Cancelled.
LayoutTrial tried_layouts(const baker::Scene& scene, const baker::SurfacePlan& surface,
                          const baker::BakeSettings& chord, const baker::ProgressCallback& progress);

}  // namespace lumi::tools
