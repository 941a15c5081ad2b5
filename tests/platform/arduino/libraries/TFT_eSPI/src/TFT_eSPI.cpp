// SPDX-License-Identifier: MIT
#include "TFT_eSPI.h"

#include <stdio.h>
#include <stdlib.h>

static constexpr int32_t kSide = 240;

void TFT_eSPI::init(uint8_t)
{
    is_ready_ = true;
}

void TFT_eSPI::setSwapBytes(bool swap)
{
    swaps_ = swap;
}

void TFT_eSPI::fillScreen(uint32_t) {}

void TFT_eSPI::pushImage(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t* data)
{
    if (!is_ready_ || swaps_ || x != 0 || y != next_row_ || w != kSide) {
        fprintf(stderr, "TFT_eSPI: not the next rows of the picture, or not as they are sent\n");
        exit(1);
    }
    fwrite(data, sizeof *data, static_cast<size_t>(w * h), stdout);
    next_row_ = (y + h) % kSide;
}
