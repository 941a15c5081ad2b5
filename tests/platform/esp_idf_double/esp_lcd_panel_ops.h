// SPDX-License-Identifier: MIT
// Declares as much of ESP-IDF as core's example takes.
#pragma once

typedef int esp_err_t;
#define ESP_OK 0
typedef struct esp_lcd_panel_t* esp_lcd_panel_handle_t;
extern "C" esp_err_t esp_lcd_panel_draw_bitmap(esp_lcd_panel_handle_t panel, int x_start, int y_start, int x_end,
                                               int y_end, const void* color_data);
