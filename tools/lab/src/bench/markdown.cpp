// SPDX-License-Identifier: MIT
#include "bench/markdown.h"

#include <algorithm>

#include "bench/tables.h"

namespace lumi::bench
{
namespace
{

std::string opening(const FieldSettings& field)
{
    return "# Speed against accuracy\n\n"
           "Written by `lumi bench --markdown docs/log/tradeoff.md --plot docs/img`; every number is measured by that "
           "run unless the text\nsays that it is modelled. Instructions are counted by QEMU (`-icount shift=0`) and "
           "are the "
           "same in every run.\n\n"
           "What is drawn: `" +
           field.scene.filename().string() + "` as a field of " + std::to_string(field.origins) + " × " +
           std::to_string(field.directions) + " rays with " + std::to_string(field.samples) +
           " light paths a texel, on 240 × 240 pixels of\nRGB565 over black, in stripes of 16 rows. Views: *generic* "
           "and "
           "*pole* (straight down) from 3 radii, the sphere's disc 232\npixels wide, 42,272 covered pixels; *close* "
           "from "
           "1.3 radii, all 57,600 pixels covered. Cost is the whole frame, rows and\nrim included, divided by covered "
           "pixels. S is the span length: hits are exact every S pixels of a row, from 8 on at the corners of "
           "tiles\nof "
           "S × 8 pixels inside the sphere; in between lattice coordinates are linear. *exact* is render(): "
           "every\n"
           "pixel exact.\n\n";
}

// The renderer with the best picture that reaches a rate on a part, by order of kModes, then by longer spans last.
std::string best_at(const Results& results, size_t chip_at, double wanted_fps)
{
    const Chip& chip = kChipList[chip_at];
    for (const char* mode : {"paper", "linear", "dither", "nearest"}) {
        for (const int span : {4, 8, 16}) {
            for (const std::string& texel : kTexels) {
                const Result* result = find_result(results, chip.core, mode, texel, span, "generic");
                if (result == nullptr) continue;
                const double fps = frames_per_second(chip, result->count.instructions, result->traffic[chip_at].misses);
                if (fps >= wanted_fps)
                    return std::string(mode) + " " + texel + ", S = " + std::to_string(span) + " (" +
                           decimal_text(fps, 0) + ")";
            }
        }
    }
    return "none";
}

std::string choice_table(const Results& results)
{
    const std::vector<std::string> titles = {"part", "10 frames/s", "20 frames/s", "30 frames/s", "60 frames/s"};
    std::string text = table_row(titles) + table_rule(titles.size());
    for (size_t i = 0; i < kChips; ++i) {
        std::vector<std::string> cells = {kChipList[i].title};
        for (const double fps : {10.0, 20.0, 30.0, 60.0}) cells.push_back(best_at(results, i, fps));
        text += table_row(cells);
    }
    return text;
}

std::string how_to_choose(const Results& results)
{
    return "## How to choose\n\n"
           "1. **Reconstruction** decides the looks: *nearest* shows the lattice's cells as parallelograms, *voronoi* "
           "in their true\n   shape, *dither* trades them for a fine grain that the eye averages, *linear* (3×3) is "
           "smooth, *paper* (5×5) is\n   smoother still and dearest.\n"
           "2. **Texels** decide flash and tint: palette8 and luma8 take one byte, RGB565 two, RGB888 three. Smaller "
           "texels also touch\n   fewer flash lines, see *Frame rates of named parts*.\n"
           "3. **Span** decides speed: a long one while the object moves, a short one when it rests. *Accuracy* says "
           "what that costs.\n"
           "4. A part is limited by its display, its arithmetic or its flash; the table below takes the worst of "
           "them.\n\n"
           "The best reconstruction, then the shortest span, then the finest texel that reaches a rate in the model "
           "below (generic view;\nin brackets the modelled rate):\n\n" +
           choice_table(results) + "\n";
}

std::string surface_section(const SurfaceResults& surface)
{
    if (surface.results.empty()) return "";
    const SurfaceFacts& field = surface.field;
    return "## Surface fields\n\n`" + field.name + "`, a surface field of " + std::to_string(field.bytes) + " bytes, " +
           std::to_string(field.triangles) + " triangles and " + std::to_string(field.vertices) +
           " vertices (SHA-256\n`" + field.sha256 +
           "`), in the same frames and stripes.\nInstructions per covered pixel of the sphere, generic view; dB and "
           "worst pixel are against the twin in double precision with one\nsample or 2 × 2 (*antialiased* is judged by "
           "2 × 2). RAM: the frame and a stripe's samples, its pixels left out.\n\n" +
           surface_table(surface) +
           "\nOf these, by part (generic view): *edges* are triangles and rows without their samples.\n\n" +
           surface_split_table(surface) +
           "\nFrame rates in the model of *Frame rates of named parts*, flash lines missed by reads of the field; two "
           "cores draw alternate stripes\nafter one of them has prepared the frame, and wait for flash as long as one "
           "does.\n\n" +
           surface_chip_table(surface) + "\n";
}

std::string parts_model()
{
    std::string text =
        "## Frame rates of named parts (modelled)\n\n"
        "Per frame: counted instructions × clocks per instruction ÷ clock, plus misses × the cost of a miss; the "
        "display "
        "(16 bits a pixel\nover SPI at 62.5 MHz, DMA beside the drawing) caps all at 67.8. Misses come from replaying "
        "the "
        "renderer's texel and palette\nreads through the part's cache. Code, tables and stack are taken to be in RAM "
        "or "
        "to hit. **Clocks per instruction and miss\ncosts are estimates from data sheets, not measurements.**\n\n";
    const std::vector<std::string> titles = {"part",     "code",  "MHz", "clocks/instruction", "cache, ways, line",
                                             "miss, ns", "remark"};
    text += table_row(titles) + table_rule(titles.size());
    for (const Chip& chip : kChipList)
        text += table_row({chip.title, chip.core, decimal_text(chip.clock_mhz, 0),
                           decimal_text(chip.clocks_per_instruction, 2),
                           std::to_string(chip.cache.bytes) + " B, " + std::to_string(chip.cache.ways) + ", " +
                               std::to_string(chip.cache.line_bytes) + " B",
                           decimal_text(chip.miss_ns, 0), chip.remark});
    return text + "\n";
}

std::string accuracy_section(const Results& results)
{
    return "## Accuracy\n\n"
           "PSNR in dB over covered pixels / worst pixel in levels of 255, 8-bit RGB pictures against the same "
           "reconstruction in double\nprecision by brute force. *nearest* and *voronoi* are judged away from cell "
           "borders (both hits "
           "more than 1/16 of the mean point spacing from\nthe true Voronoi border); *dither* against linear, both "
           "blurred over 3 × 3 pixels. ∞: no pixel differs. Every core draws the\nsame bits; the bench stops if a CRC "
           "differs.\n\n" +
           accuracy_table(results) + "\n";
}

std::string baseline_section(const Results& results, const Baselines& baselines)
{
    return "## What one would do without it\n\n"
           "The same harness, our own code, generic view, RGB565 texels. The float version is the paper's algorithm "
           "pixel "
           "by pixel; the\nsprites are 240 × 240 pixels of RGB565 with a key colour.\n\n" +
           baseline_cost_table(results, baselines.costs) +
           "\nA sprite costs next to nothing to draw; what it lacks is the view. Against the path-traced truth (64 "
           "samples a pixel, over\nblack, whole picture), with as many sprites as fit into the field's flash, spread "
           "over the sphere, the nearest one turned and\nscaled onto the view:\n\n" +
           likeness_table(baselines.pictures) +
           "\nOne view says little about a sheet of sprites: beside a sprite's own direction it is perfect, between "
           "two "
           "it jumps.\n\n";
}

std::string method(const Results& results)
{
    return "## How it was measured\n\n"
           "- **Set-up and inner loop.** The frame is drawn a second time by a renderer whose inner loop is empty (the "
           "span and all its\n  steps are computed and handed to a compiler barrier): that is set-up, the difference "
           "is "
           "the inner loop. Pixels left to the\n  exact renderer count as set-up.\n"
           "- **Code** is the size of the smallest program that draws, less that of an empty one: core's functions, "
           "tables and compiler\n  routines; opening a field and making a camera are not in it. GCC 12, `-O2`.\n"
           "- **Stack** is the deepest painted word below the caller, so the bench's own frames and one of an "
           "interrupt are in it;\n  those of core alone are proven (docs/boards.md).\n"
           "- **M0+ code** runs on an emulated Cortex-M3 that faults on unaligned access: QEMU has no ARMv6-M board "
           "with "
           "memory enough.\n"
           "- An instruction is not a clock: see the model of parts. Counters tick every 40 instructions, so a frame "
           "is "
           "known within 80.\n\n"
           "### Set-up and inner loop, instructions per covered pixel, generic view\n\n" +
           split_table(results) + "\n### Flash and stack\n\n" + memory_table(results) +
           "\n### From the generic to the polar view\n\n" + polar_table(results);
}

}  // namespace

std::string markdown_page(const Results& results, const SurfaceResults& surface, const Baselines& baselines,
                          const std::vector<std::string>& plots, const FieldSettings& field)
{
    std::string page = opening(field) + how_to_choose(results);
    for (const std::string& plot : plots) page += "![Cost and accuracy](" + plot + ")\n";
    page += "\n## At a glance\n\nInstructions per covered pixel, and PSNR against the exact picture.\n\n" +
            glance_table(results);
    page +=
        "\n## Instructions per covered pixel, generic view\n\n" + cost_table(results) + "\n" + surface_section(surface);
    page += accuracy_section(results) + parts_model() + chip_table(results) + "\n";
    return page + baseline_section(results, baselines) + method(results);
}

}  // namespace lumi::bench
