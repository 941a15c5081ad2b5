// SPDX-License-Identifier: MIT
// An ST7789 of 240 × 240 pixels on SPI0 at 62.5 MHz, fed by DMA channel 0.
#pragma once

#include <stdint.h>

namespace st7789
{

void start();
// The next bytes are a picture's first.
void begin_picture();
// Waits until the last bytes are sent, then sends these while the program goes on.
void send(const uint8_t* bytes, uint32_t count);
void wait();

}  // namespace st7789
