// SPDX-License-Identifier: MIT
#pragma once

#include "FreeRTOS.h"

extern "C" void vTaskDelay(TickType_t ticks);
