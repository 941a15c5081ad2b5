// SPDX-License-Identifier: MIT
// Results as people and programs read them.
#pragma once

#include <string>

#include "bench/matrix.h"

namespace lumi::bench
{

// A table for terminals.
std::string text_report(const Results& results, const SurfaceResults& surface);

// An array with one object a result. All have: layout (chord or surface), core, mode, view, instructions_per_pixel
// (covered ones), instructions_per_frame, covered_pixels, code_bytes, stack_bytes, psnr_db, worst_pixel, and for every
// chip misses_<chip>. A PSNR without errors is null. Chord fields: texel, span (0 is the exact renderer), setup and
// inner (per covered pixel), psnr_all_db, lines_<chip>. Surface fields: pixel; palette, vertices, lists, lights, edges,
// samples, outlines and resolve (per covered pixel, see surface_main.cpp of the bench's firmware); ram_bytes;
// fps_<chip> of one core and fps2_<chip> of both, modelled, on results of that chip's core; file, file_bytes, triangles
// and sha256 of the field.
std::string json_report(const Results& results, const SurfaceResults& surface);

}  // namespace lumi::bench
