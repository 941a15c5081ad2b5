/* SPDX-License-Identifier: MIT
 * The display of core/README.md's program in C: writes the first frame and ends. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

void panel_write(const uint8_t* pixels, uint32_t bytes);

void panel_write(const uint8_t* pixels, uint32_t bytes)
{
    static int stripes;
    fwrite(pixels, 1, bytes, stdout);
    if (++stripes == 15) exit(0);
}
