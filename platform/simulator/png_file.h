// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace simulator
{

// Red, green and blue of every pixel. False: the file could not be written.
bool write_png(const std::string& path, int side_px, const uint8_t* rgb);

}  // namespace simulator
