// SPDX-License-Identifier: MIT
// Draws a picture of a field in stripes, as a product with a display does.
#pragma once

#include <cstddef>
#include <cstdint>

// Gets a finished stripe; its memory stays untouched until the call after the next, in this frame or the next one: one
// stripe is sent to the display while the other is drawn.
using Flush = void (*)(void* context, uint8_t* pixels, uint32_t bytes);

// Null, or why the picture could not be drawn.
const char* draw_picture(const uint8_t* file, size_t file_bytes, Flush flush, void* context);
