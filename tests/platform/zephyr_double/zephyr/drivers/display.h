// SPDX-License-Identifier: MIT
// See ../device.h.
#pragma once

#include <zephyr/device.h>

struct display_buffer_descriptor {
    uint32_t buf_size;
    uint16_t width, height, pitch;
};

extern "C" int display_write(const device*, uint16_t x, uint16_t y, const display_buffer_descriptor*, const void*);
extern "C" int display_blanking_off(const device*);
