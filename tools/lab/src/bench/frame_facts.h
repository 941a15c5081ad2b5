// SPDX-License-Identifier: MIT
// This machine tells these facts about a frame of the bench; they hold for every core.
#pragma once

#include <string>

#include "bench/judge.h"
#include "files/field_file.h"
#include "lumi/bench/surface_modes.h"
#include "planner/cache_model.h"

namespace lumi::bench
{

struct FrameFacts {
    Accuracy accuracy;
    planner::AllTraffic traffic;
    uint32_t crc = 0;
};

// Facts about a frame of a chord field, in RGB565. `judge` is made for the field's lattices.
FrameFacts chord_facts(Judge& judge, const tools::FieldFile& file, const std::string& mode, int span, const View& view);

// CRC of a frame of a surface field; `pixel` is rgb565 or rgb888.
uint32_t surface_crc(const tools::FieldFile& file, const NamedSurfaceMode& mode, const std::string& pixel,
                     const View& view);

// Facts about it. The double-precision picture and the reads have opaque parts alone.
FrameFacts surface_facts(const tools::FieldFile& file, const NamedSurfaceMode& mode, const std::string& pixel,
                         const View& view);

}  // namespace lumi::bench
