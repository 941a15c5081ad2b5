// SPDX-License-Identifier: MIT
// A binary PPM picture (P6) on the host, written stripe by stripe from the panel's own RGB565 pixels.
#pragma once

#include "lumi/mps2/semihosting.h"

namespace lumi::firmware
{

class PpmFile
{
public:
    PpmFile(const char* path, uint32_t width_px, uint32_t height_px);

    // Appends pixels (RGB565, two bytes each in the CPU's byte order); false after a failure.
    bool append_rgb565(const uint8_t* pixels, uint32_t bytes);
    bool ok() const { return file_.ok(); }

private:
    mps2::OutputFile file_;
};

}  // namespace lumi::firmware
