// SPDX-License-Identifier: MIT
// Rows as people and programs read them.
#pragma once

#include <string>

#include "bench/matrix.h"

namespace lumi::bench
{

// A table for terminals.
std::string text_report(const Rows& rows);

// An array with one object a row: core, mode, texel, span, view, instructions_per_pixel, setup, inner (per covered
// pixel), instructions_per_frame, covered_pixels, code_bytes, stack_bytes, psnr_db, psnr_all_db, worst_pixel, and for
// every chip lines_<chip> and misses_<chip>. Span 0 is the exact renderer. A PSNR without errors is null.
std::string json_report(const Rows& rows);

}  // namespace lumi::bench
