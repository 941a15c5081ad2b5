// SPDX-License-Identifier: MIT
#include <esp_timer.h>
#include <freertos/FreeRTOS.h>
#include <freertos/task.h>
#include <lumi_measure.h>
#include <sdkconfig.h>
#include <stdio.h>

#include "desk_clock.h"  // written by lumi_add_field

using Panel = lumi::Screen<240, 240, 16>;
static desk_clock_view<Panel> view;

static uint32_t now_us()
{
    return static_cast<uint32_t>(esp_timer_get_time());
}

static void print(const char* text)
{
    printf("%s", text);
}

extern "C" void app_main()
{
    const measure::Board board = {CONFIG_IDF_TARGET, CONFIG_ESP_DEFAULT_CPU_FREQ_MHZ, now_us, print};
    for (;; vTaskDelay(pdMS_TO_TICKS(5000)))
        measure::surface<Panel>(board, {"desk_clock", desk_clock, desk_clock_size()}, view);
}
