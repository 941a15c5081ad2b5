// SPDX-License-Identifier: MIT
// As much of the library LovyanGFX as lumi's sketch calls, on a display of 240 × 240 pixels behind a DMA that ends a
// transfer when it is waited for, not before (slow_dma.h). `tools/lab/devices.sh --lovyangfx` compiles the sketch with
// the real headers.
#pragma once

#include <stdint.h>

namespace lgfx
{

// Two bytes, red first.
struct swap565_t {
    uint16_t raw;
};

}  // namespace lgfx

class LGFX
{
public:
    bool init();
    void initDMA();
    void fillScreen(uint32_t colour);
    void startWrite();
    void waitDMA();
    void pushImageDMA(int32_t x, int32_t y, int32_t w, int32_t h, const lgfx::swap565_t* data);

private:
    bool has_dma_ = false, has_bus_ = false;
    int32_t next_row_ = 0;
};
