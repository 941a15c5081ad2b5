/* SPDX-License-Identifier: MIT
 * The display of core/README.md's program in C: writes the first two frames and ends. */
#include <stdint.h>
#include <stdlib.h>

#include "slow_dma.h"

void panel_write(const uint8_t* pixels, uint32_t bytes);

void panel_write(const uint8_t* pixels, uint32_t bytes)
{
    static int stripes;
    dma_start(pixels, bytes);
    dma_wait();
    if (++stripes == 2 * 15) exit(0);
}
