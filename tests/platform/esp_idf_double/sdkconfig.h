// SPDX-License-Identifier: MIT
#pragma once

#define CONFIG_IDF_TARGET "esp32c3"
#define CONFIG_ESP_DEFAULT_CPU_FREQ_MHZ 160
