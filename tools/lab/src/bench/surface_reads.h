// SPDX-License-Identifier: MIT
// Estimates what drawing a frame of a surface field reads of its file: vertices and patches once, view tables of lit
// vertices, then for each stripe the patches that show there and a texel for each sample. Samples that end up hidden
// and triangles that reach a stripe without a sample are left out.
#pragma once

#include <vector>

#include "files/field_file.h"
#include "lumi/bench/surface_modes.h"
#include "planner/chips.h"

namespace lumi::bench
{

using planner::Read;

// In the renderer's order; addresses count from the file's start.
std::vector<Read> reads_of(const tools::FieldFile& file, const View& view, SurfaceMode mode);

}  // namespace lumi::bench
