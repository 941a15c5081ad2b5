// SPDX-License-Identifier: MIT
// Declares as much of Zephyr as core's sample takes: it is compiled against these declarations, not against Zephyr.
#pragma once

#include <stdint.h>

struct device;

#define DT_CHOSEN(name) name
#define DEVICE_DT_GET(name) (&name)
extern "C" const device zephyr_display;
extern "C" bool device_is_ready(const device*);
