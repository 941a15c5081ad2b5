// SPDX-License-Identifier: MIT
// Files of small pictures, in memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lumi::baker::testing
{

// A PNG as libpng writes it: `colour` is one of its PNG_COLOR_TYPEs, `rows` hold the samples as the file does.
struct PngKind {
    int colour;
    int depth = 8;
    bool interlaced = false;
    std::vector<uint8_t> palette = {}, palette_alpha = {};
};
std::string png(const PngKind& kind, uint32_t width, uint32_t height, std::vector<uint8_t> rows);

// One row of 8-bit pixels for each `width` of them.
std::string rgb_png(uint32_t width, const std::vector<uint8_t>& rgb);

// A gradient.
std::string jpeg(int width, int height, bool grey = false, bool progressive = false);

}  // namespace lumi::baker::testing
