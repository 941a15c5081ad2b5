// SPDX-License-Identifier: MIT
// RAM, stack and frame rates of fields on named parts. Rates come from models of instructions, fitted to what boards
// executed (docs/log/tradeoff.md); those of chord fields add what their rows of texels miss in the parts' caches.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/draw.h"
#include "files/field_file.h"
#include "lumi/host/view_memory.h"
#include "planner/chips.h"
#include "planner/work.h"

namespace lumi::planner
{

// A way to draw a chord field.
struct ChordMode {
    const char* name;
    tools::Mode mode;
};

// The dearest and best mode comes first.
const std::vector<ChordMode>& chord_modes();

// A part and a pace, as --for asks for them.
struct Pace {
    const Chip* chip;
    double frames_per_second;
    bool is_asked = false;  // the rate was said, so a field may be planned for it
    int cores = 1;          // that draw
};
// The pace of a part without a rate: an object that people turn moves, and does not jump.
inline constexpr double kUsualPace = 10;

// "rp2040@30fps", "rp2040", "rp2040x2@30fps" for both cores of one that has two; nothing for other texts, unknown parts
// and rates that are not above 0.
std::optional<Pace> parse_pace(const std::string& text);
// Returns "rp2040, rp2350, … or esp32c3".
std::string chip_names();

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

// Flash lines of so many bytes that a frame misses, about.
double surface_misses(const SurfaceField& field, const FrameWork& work, const host::ScreenSize& screen,
                      double line_bytes);

// Frames a second by one core, over poses all around the sphere.
struct PartRate {
    const Chip* chip;
    double mean, worst;
    double instructions;     // a frame, in the mean
    double mean_of_two = 0;  // by two cores of a surface field, where there are two

    double of(int cores) const { return cores == 2 ? mean_of_two : mean; }
};

inline constexpr int kRatedPoses = 200;

std::vector<PartRate> surface_rates(const SurfaceField& field, SurfaceMode mode, const host::ScreenSize& screen = {},
                                    int poses = kRatedPoses);

// From how many poses such a screen is rated: kRatedPoses up to 480 × 480 pixels; of larger ones fewer, since each pose
// is drawn.
int rated_poses(const host::ScreenSize& screen);

// The span that rates are told for unless they say which.
inline constexpr int32_t kRatedSpanPx = 8;

// Frames a second by one core, of a view that the sphere fills, in the order of kChipList; mean and worst are the same.
std::vector<PartRate> chord_rates(const Field& field, tools::Mode mode, int32_t span_px = kRatedSpanPx,
                                  const host::ScreenSize& screen = {});

}  // namespace lumi::planner
