// SPDX-License-Identifier: MIT
#include "TFT_eSPI.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static constexpr int32_t kSide = 240;
static uint16_t screen[kSide][kSide];

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
    if (!is_ready_ || swaps_ || x < 0 || y < 0 || x + w > kSide || y + h > kSide) {
        fprintf(stderr, "TFT_eSPI: pixels beside the picture, or not as they are sent\n");
        exit(1);
    }
    for (int32_t row = 0; row < h; ++row)
        memcpy(screen[y + row] + x, data + row * w, sizeof *data * static_cast<size_t>(w));
}

void after_loop()
{
    fwrite(screen, 1, sizeof screen, stdout);
}
