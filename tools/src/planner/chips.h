// SPDX-License-Identifier: MIT
// Named parts, and the model that turns instructions and cache misses into frames per second. Instructions are counted;
// clocks per instruction, miss costs and the display are assumptions, stated here and printed with every report.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lumi::planner
{

// ways = lines makes it fully associative. All powers of two; line_bytes · ways divides bytes.
struct CacheShape {
    uint32_t bytes, ways, line_bytes;

    uint32_t sets() const { return bytes / (line_bytes * ways); }
};

struct Chip {
    const char* key;    // in JSON keys: misses_<key>
    const char* title;  // people call it so
    const char* core;   // whose code is counted for it
    double clock_mhz;
    double clocks_per_instruction;
    CacheShape cache;
    double miss_ns;
    const char* remark;
    uint32_t ram_bytes = 0;     // the longest piece on the chip: what one array can take at most
    int cores = 1;              // remark and rates are of one
    uint32_t flash_bytes = 0;   // that a field must fit where it lies inside the chip; 0: it lies outside
    bool is_estimated = false;  // instructions are those of a CPU with another instruction set
};

// With a star where rates are estimated.
std::string marked_title(const Chip& chip);

inline constexpr size_t kChips = 8;
extern const std::array<Chip, kChips> kChipList;

// A panel with pixels of 16 bits behind SPI at 62.5 MHz, fed by DMA while the next stripe is drawn.
inline constexpr double kDisplayHz = 62.5e6;
inline constexpr double kBitsAPixel = 16;
inline constexpr double kUsualPixels = 240 * 240;

constexpr double display_frames_per_second(double pixels)
{
    return kDisplayHz / (kBitsAPixel * pixels);
}

// Whichever of drawing and sending takes longer limits the rate.
double frames_per_second(const Chip& chip, uint64_t instructions, uint64_t misses, double pixels = kUsualPixels);

// A set-associative cache with least-recently-used replacement, fed with the addresses that a renderer reads.

struct Read {
    uint32_t address, bytes;
};

class CacheModel
{
public:
    explicit CacheModel(const CacheShape& shape);

    // A read that crosses into another line counts for both.
    void read(const Read& read);

    uint64_t misses() const { return misses_; }

private:
    void touch(uint32_t line);

    CacheShape shape_;
    std::vector<uint32_t> lines_;  // per set, most recently used first
    uint64_t misses_ = 0;
};

// The reads go through the caches of kChipList.
using Misses = std::array<uint64_t, kChips>;
Misses misses_by_chip(const std::vector<Read>& reads);

}  // namespace lumi::planner
