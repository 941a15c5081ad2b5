// SPDX-License-Identifier: MIT
// The commands of the program, one file each.
#pragma once

#include <string>

namespace lumi::tools::bench
{

// How long this machine draws an RGB565 chord field by the paper's modes, in RGB888, and what of it is reading texels;
// as JSON on stdout. Processor time of one core, so other programs count little. Throws on a field of another kind.
void print_drawing(const std::string& field, int width_px, int height_px);

// A plot of lumi/bench, told as JSON: title, x_title, y_title, series: [{name, points: [[x, y, label]]}].
void write_plot(const std::string& data, const std::string& svg);

}  // namespace lumi::tools::bench
