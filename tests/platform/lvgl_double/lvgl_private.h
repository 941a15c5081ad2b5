/* SPDX-License-Identifier: MIT */
#include "lvgl.h"
