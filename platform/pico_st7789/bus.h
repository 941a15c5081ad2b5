// SPDX-License-Identifier: MIT
// These wires lie between the RP2040 and the panel: SPI0 at 62.5 MHz (SCK 18, TX 19), CS 17, DC 20, RST 21, and a DMA
// channel.
#pragma once

#include <stdint.h>

namespace bus
{

void start();
// The next bytes are a command's code, or data.
void take_command();
void take_data();
void put(uint8_t byte);
// Waits until the last bytes of send() have left memory, then sends these while the program goes on.
void send(const uint8_t* bytes, uint32_t count);
// Until everything is sent.
void wait();

}  // namespace bus
