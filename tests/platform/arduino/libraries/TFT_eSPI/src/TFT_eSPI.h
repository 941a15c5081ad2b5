// SPDX-License-Identifier: MIT
// Stands for as much of the library TFT_eSPI as lumi's sketch calls, on a display of 240 × 240 pixels: what it shows
// goes to standard output after each loop(). `tools/lab/devices.sh --tft-espi` compiles the
// sketch with the real header.
#pragma once

#include <stdint.h>

#define TFT_BLACK 0x0000

class TFT_eSPI
{
public:
    void init(uint8_t colour_tab = 0);
    void setSwapBytes(bool swap);
    void fillScreen(uint32_t colour);
    // Bytes as they lie in memory, unless they are to be swapped. Comes back when they are sent.
    void pushImage(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t* data);

private:
    bool is_ready_ = false, swaps_ = false;
};
