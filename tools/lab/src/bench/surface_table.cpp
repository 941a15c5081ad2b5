// SPDX-License-Identifier: MIT
#include "bench/surface.h"
#include "bench/tables.h"

namespace lumi::bench
{
namespace
{

// Modes and kinds of pixels of which there is a result, in order.
template <class Visit>
void for_each_renderer(const SurfaceResults& surface, const Visit& visit)
{
    for (const std::string& mode : surface_mode_names())
        for (const std::string& pixel : kPixels)
            for (const SurfaceResult& result : surface.results) {
                if (result.count.mode != mode || result.pixel != pixel) continue;
                visit(mode, pixel);
                break;
            }
}

std::string exactness(const SurfaceResult* result)
{
    if (result == nullptr) return kNotMeasured;
    return decimal_text(result->accuracy.psnr_db) + " / " + std::to_string(result->accuracy.worst_pixel);
}

// The dB of any core: all draw the same bits.
const SurfaceResult* result_of_any(const SurfaceResults& surface, const std::string& mode, const std::string& pixel,
                                   const std::string& view)
{
    for (const std::string& core : kCores)
        if (const SurfaceResult* result = find_result(surface, core, mode, pixel, view)) return result;
    return nullptr;
}

}  // namespace

std::string surface_table(const SurfaceResults& surface)
{
    std::vector<std::string> titles = {"renderer"};
    for (const std::string& core : kCores) titles.push_back(core);
    for (const std::string& view : kViewNames) titles.push_back(view + ", dB / worst");
    titles.insert(titles.end(), {"RAM, bytes", "m0plus code / stack, bytes"});
    std::string text = table_row(titles) + table_rule(titles.size());
    for_each_renderer(surface, [&](const std::string& mode, const std::string& pixel) {
        std::vector<std::string> cells = {mode + " " + pixel};
        for (const std::string& core : kCores) {
            const SurfaceResult* result = find_result(surface, core, mode, pixel, "generic");
            cells.push_back(result == nullptr ? kNotMeasured
                                              : decimal_text(result->count.per_pixel(result->count.instructions)));
        }
        for (const std::string& view : kViewNames)
            cells.push_back(exactness(result_of_any(surface, mode, pixel, view)));
        const SurfaceResult* any = result_of_any(surface, mode, pixel, "generic");
        cells.push_back(any == nullptr ? kNotMeasured : std::to_string(any->count.ram_bytes));
        const SurfaceResult* small = find_result(surface, "m0plus", mode, pixel, "generic");
        cells.push_back(small == nullptr
                            ? kNotMeasured
                            : std::to_string(small->code_bytes) + " / " + std::to_string(small->count.stack_bytes));
        text += table_row(cells);
    });
    return text;
}

std::string surface_split_table(const SurfaceResults& surface)
{
    const std::vector<std::string> titles = {"renderer", "vertices", "lists",   "view tables", "edges",
                                             "samples",  "outlines", "resolve", "palette"};
    std::string text = table_row(titles) + table_rule(titles.size());
    for (const char* core : {"m4", "m0plus"}) {
        for_each_renderer(
            surface,
            [&](const std::string& mode, const std::string& pixel) {
                const SurfaceResult* result = find_result(surface, core, mode, pixel, "generic");
                if (result == nullptr) return;
                const SurfaceCount& c = result->count;
                std::vector<std::string> cells = {std::string(core) + " " + mode + " " + pixel};
                for (const uint64_t part :
                     {c.vertices, c.lists, c.lights, c.edges, c.samples, c.outlines, c.resolve, c.palette})
                    cells.push_back(decimal_text(c.per_pixel(part)));
                text += table_row(cells);
            });
    }
    return text;
}

std::string surface_chip_table(const SurfaceResults& surface)
{
    std::vector<std::string> titles = {"renderer"};
    for (const Chip& chip : kChipList) titles.push_back(std::string(chip.title) + ": misses, frames/s");
    std::string text = table_row(titles) + table_rule(titles.size());
    for_each_renderer(surface, [&](const std::string& mode, const std::string& pixel) {
        std::vector<std::string> cells = {mode + " " + pixel};
        for (size_t i = 0; i < kChips; ++i) {
            const Chip& chip = kChipList[i];
            const SurfaceResult* result = find_result(surface, chip.core, mode, pixel, "generic");
            if (result == nullptr) {
                cells.push_back(kNotMeasured);
                continue;
            }
            const SurfaceCount& c = result->count;
            const uint64_t misses = result->traffic[i].misses;
            std::string cell =
                std::to_string(misses) + ", **" + decimal_text(frames_per_second(chip, c.instructions, misses)) + "**";
            if (chip.cores == 2)
                cell += ", both cores **" +
                        decimal_text(frames_per_second_of_two(chip, c.preparing(), c.instructions, misses)) + "**";
            cells.push_back(cell);
        }
        text += table_row(cells);
    });
    return text;
}

}  // namespace lumi::bench
