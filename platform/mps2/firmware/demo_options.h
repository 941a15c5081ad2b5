// SPDX-License-Identifier: MIT
// The command line of lumi_demo_firmware.
#pragma once

#include <cstdint>

namespace lumi::firmware
{

enum class Mode : uint8_t { nearest, linear, paper };

struct DemoOptions {
    uint32_t frames = 1;  // frames in one turn around the object; 1 .. kMaxFrames
    Mode mode = Mode::linear;
    bool verify = false;                 // check the CRC of every section first
    const char* write_prefix = nullptr;  // write frame k to "<prefix>-<k>.ppm" on the host
};

inline constexpr uint32_t kMaxFrames = 999;

// Fills `out`; on failure returns the argument that is wrong, else null. argv[0] is skipped.
const char* parse(int argc, char** argv, DemoOptions& out);

extern const char* const kDemoUsage;

}  // namespace lumi::firmware
