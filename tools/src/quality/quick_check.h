// SPDX-License-Identifier: MIT
// Finds what a field shows in seconds: few views, small pictures, few light paths. `lumi report` measures properly.
#pragma once

#include "files/field_file.h"
#include "lumi/baker/reference.h"

namespace lumi::quality
{

// Mean PSNR in dB over kQuickViews views, in the uppermost share `cap` of the sphere, by the best mode of the field.
// The noise of the references is taken out: two of them, independent, give the squared error as the mean of (x - a)(x -
// b). Throws Cancelled.
double quick_psnr_db(const baker::Scene& scene, const tools::FieldFile& field, double cap, unsigned threads,
                     const baker::ProgressCallback& progress = {});

inline constexpr int kQuickViews = 4;

}  // namespace lumi::quality
