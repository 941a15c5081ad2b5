// SPDX-License-Identifier: MIT
#include "LovyanGFX.hpp"

#include <stdio.h>
#include <stdlib.h>

#include "slow_dma.h"

static constexpr int32_t kSide = 240;

bool LGFX::init()
{
    return true;
}

void LGFX::initDMA()
{
    has_dma_ = true;
}

void LGFX::fillScreen(uint32_t) {}

void LGFX::startWrite()
{
    has_bus_ = true;
}

void LGFX::waitDMA()
{
    dma_wait();
}

void LGFX::pushImageDMA(int32_t x, int32_t y, int32_t w, int32_t h, const lgfx::swap565_t* data)
{
    if (!has_dma_ || !has_bus_ || x != 0 || y != next_row_ || w != kSide) {
        fprintf(stderr, "LovyanGFX: not the next rows of the picture, or no DMA or bus\n");
        exit(1);
    }
    dma_start(reinterpret_cast<const uint8_t*>(data), static_cast<uint32_t>(w * h) * sizeof *data);
    next_row_ = (y + h) % kSide;
}
