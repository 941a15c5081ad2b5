// SPDX-License-Identifier: MIT
// The calls that main.cpp takes from panel.cpp, which you write for your board, as the example of its panel's driver
// does it.
#pragma once

#include <esp_lcd_panel_ops.h>

// A panel of 466 × 466 pixels of 16 bits behind SPI or QSPI, switched on; nullptr if it does not answer.
esp_lcd_panel_handle_t make_panel();
