// SPDX-License-Identifier: MIT
// What is measured: one result per core, mode, texel format, span length and view.
#pragma once

#include <array>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include "bench/chips.h"
#include "lumi/chord/texel.h"

namespace lumi::bench
{

inline const std::vector<std::string> kCores = {"m0plus", "m3", "m4", "m7"};
inline const std::vector<std::string> kModes = {"nearest", "voronoi", "dither", "linear", "paper"};
inline const std::vector<std::string> kTexels(std::begin(AllTexels::kNames), std::end(AllTexels::kNames));
inline const std::vector<std::string> kViewNames = {"generic", "pole", "close"};

// Span 0: render() in place of render_spans(), every pixel exact; it has no dither, and voronoi is its nearest.
inline const std::vector<int> kSpans = {0, 2, 4, 8, 16};

// Of surface fields' frames.
inline const std::vector<std::string> kPixels = {"rgb565", "rgb888"};

struct Matrix {
    std::vector<std::string> cores = kCores, modes = kModes, texels = kTexels, views = kViewNames, pixels = kPixels;
    std::vector<int> spans = {0, 4, 8, 16};
};

// Few results, soon done: two cores, the cheapest and the dearest of the usual modes.
Matrix quick_matrix();

// What a core executed for one frame.
struct Count {
    std::string view;
    int span = 0;
    uint64_t covered = 0, instructions = 0, setup = 0;
    uint32_t stack_bytes = 0, crc = 0;
};

struct Accuracy {
    double psnr_db = 0;        // nearest: outside cell borders; dither: both pictures blurred; over covered pixels
    double psnr_all_db = 0;    // over all covered pixels as they are
    uint32_t worst_pixel = 0;  // levels of 255, over the pixels of psnr_db
};

// What this machine can say about a frame; the same for every core.
struct HostFacts {
    Accuracy accuracy;
    std::array<Traffic, kChips> traffic;
    uint32_t crc = 0;
};

struct Result {
    std::string core, mode, texel;
    Count count;
    uint32_t code_bytes = 0;
    Accuracy accuracy;
    std::array<Traffic, kChips> traffic;

    double instructions_per_pixel() const { return per_pixel(count.instructions); }
    double setup_per_pixel() const { return per_pixel(count.setup); }
    double inner_per_pixel() const { return instructions_per_pixel() - setup_per_pixel(); }

private:
    double per_pixel(uint64_t instructions) const
    {
        return static_cast<double>(instructions) / static_cast<double>(count.covered);
    }
};

using Results = std::vector<Result>;

// Of a surface field's frame, with what its parts take: surface_main.cpp of the firmware says what they are.
struct SurfaceCount {
    std::string view, mode;
    uint64_t covered = 0, instructions = 0;
    uint64_t palette = 0, vertices = 0, lists = 0, lights = 0, edges = 0, samples = 0, outlines = 0, resolve = 0;
    uint32_t stack_bytes = 0, ram_bytes = 0, crc = 0;

    double per_pixel(uint64_t count) const { return static_cast<double>(count) / static_cast<double>(covered); }
    // What one core does for both where two draw.
    uint64_t preparing() const { return palette + vertices + lists + lights; }
};

struct SurfaceResult {
    std::string core, pixel;
    SurfaceCount count;
    uint32_t code_bytes = 0;
    Accuracy accuracy;
    std::array<Traffic, kChips> traffic;
};

// Which file was drawn.
struct SurfaceFacts {
    std::string name;
    uint32_t bytes = 0, vertices = 0, patches = 0, triangles = 0;
    std::string sha256;
};

struct SurfaceResults {
    SurfaceFacts field;
    std::vector<SurfaceResult> results;
};

// The first result of these properties, or null.
const SurfaceResult* find_result(const SurfaceResults& surface, const std::string& core, const std::string& mode,
                                 const std::string& pixel, const std::string& view);
const Result* find_result(const Results& results, const std::string& core, const std::string& mode,
                          const std::string& texel, int span, const std::string& view);

}  // namespace lumi::bench
