// SPDX-License-Identifier: MIT
// Draws on this machine what the boards draw: the same templates, the same bits.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "image/picture.h"
#include "lumi/chord/camera.h"
#include "lumi/chord/field.h"
#include "planner/chips.h"

namespace lumi::bench
{

using planner::Read;

struct HostFrame {
    tools::Picture picture;   // drawn as RGB888, so that a display's rounding hides nothing
    uint32_t rgb565_crc = 0;  // CRC of the frame that the boards draw
    std::vector<Read> reads;  // each read of texels and palette, in order; addresses count from the field file's start
};

// `mode` is nearest, linear or paper; `span` 0 is render() in place of render_spans(): every pixel
// exact. The field decides the texel policy. `file` is where the field's bytes
// begin.
HostFrame draw_on_host(const std::string& mode, int span, const Field& field, const uint8_t* file,
                       const Camera& camera);

}  // namespace lumi::bench
