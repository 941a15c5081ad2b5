// SPDX-License-Identifier: MIT
// RAM and stack that drawing a field takes on a device.
#pragma once

#include "files/field_file.h"
#include "lumi/host/view_memory.h"

namespace lumi::planner
{

// Bytes of what is there all the time: the view that `lumi embed` writes, and the pixels of a stripe in RGB565.
struct Ram {
    uint32_t view = 0, stripe = 0;

    uint64_t all() const { return uint64_t{view} + stripe; }
};

// `finest`: what the view of a surface field can draw; it has no meaning for chord fields.
Ram ram_of(const tools::FieldFile& field, SurfaceMode finest, const host::ScreenSize& screen);
Ram ram_of(const host::SurfaceCounts& field, const host::ScreenSize& screen);

// Bytes of stack that preparing and drawing stay below on every Cortex-M, as tests/platform/cross_tests.cmake proves.
inline constexpr uint32_t kSurfaceStackBytes = 3072, kSpanStackBytes = 2624, kExactStackBytes = 1024;
uint32_t stack_of(const tools::FieldFile& field);

}  // namespace lumi::planner
