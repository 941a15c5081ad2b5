// SPDX-License-Identifier: MIT
#include "bench/report.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

namespace lumi::bench
{
namespace
{

using nlohmann::ordered_json;

// Hundredths: finer digits would mean nothing, and text stays short.
double hundredths(double value)
{
    return std::round(value * 100) / 100;
}

ordered_json decibels(double value)
{
    return std::isinf(value) ? ordered_json() : ordered_json(hundredths(value));
}

ordered_json json_result(const Result& result)
{
    ordered_json json;
    json["layout"] = "chord";
    json["core"] = result.core;
    json["mode"] = result.mode;
    json["texel"] = result.texel;
    json["span"] = result.count.span;
    json["view"] = result.count.view;
    json["instructions_per_pixel"] = hundredths(result.instructions_per_pixel());
    json["setup"] = hundredths(result.setup_per_pixel());
    json["inner"] = hundredths(result.inner_per_pixel());
    json["instructions_per_frame"] = result.count.instructions;
    json["covered_pixels"] = result.count.covered;
    json["code_bytes"] = result.code_bytes;
    json["stack_bytes"] = result.count.stack_bytes;
    json["psnr_db"] = decibels(result.accuracy.psnr_db);
    json["psnr_all_db"] = decibels(result.accuracy.psnr_all_db);
    json["worst_pixel"] = result.accuracy.worst_pixel;
    for (size_t i = 0; i < kChips; ++i) {
        json[std::string("lines_") + kChipList[i].key] = result.traffic[i].lines;
        json[std::string("misses_") + kChipList[i].key] = result.traffic[i].misses;
    }
    return json;
}

void put_parts(ordered_json& json, const SurfaceCount& c)
{
    const std::pair<const char*, uint64_t> parts[] = {
        {"palette", c.palette}, {"vertices", c.vertices}, {"lists", c.lists},       {"lights", c.lights},
        {"edges", c.edges},     {"samples", c.samples},   {"outlines", c.outlines}, {"resolve", c.resolve}};
    for (const auto& [name, count] : parts) json[name] = hundredths(c.per_pixel(count));
}

void put_rates(ordered_json& json, const SurfaceResult& result)
{
    for (size_t i = 0; i < kChips; ++i) {
        const Chip& chip = kChipList[i];
        const uint64_t misses = result.traffic[i].misses, instructions = result.count.instructions;
        json[std::string("misses_") + chip.key] = misses;
        if (chip.core != result.core) continue;
        json[std::string("fps_") + chip.key] = hundredths(frames_per_second(chip, instructions, misses));
        if (chip.cores == 2)
            json[std::string("fps2_") + chip.key] =
                hundredths(frames_per_second_of_two(chip, result.count.preparing(), instructions, misses));
    }
}

ordered_json json_result(const SurfaceResult& result, const SurfaceFacts& field)
{
    ordered_json json;
    json["layout"] = "surface";
    json["core"] = result.core;
    json["mode"] = result.count.mode;
    json["pixel"] = result.pixel;
    json["view"] = result.count.view;
    json["instructions_per_pixel"] = hundredths(result.count.per_pixel(result.count.instructions));
    put_parts(json, result.count);
    json["instructions_per_frame"] = result.count.instructions;
    json["covered_pixels"] = result.count.covered;
    json["code_bytes"] = result.code_bytes;
    json["stack_bytes"] = result.count.stack_bytes;
    json["ram_bytes"] = result.count.ram_bytes;
    json["psnr_db"] = decibels(result.accuracy.psnr_db);
    json["worst_pixel"] = result.accuracy.worst_pixel;
    put_rates(json, result);
    json["file"] = field.name;
    json["file_bytes"] = field.bytes;
    json["triangles"] = field.triangles;
    json["sha256"] = field.sha256;
    return json;
}

__attribute__((format(printf, 2, 3))) void append(std::string& text, const char* format, ...)
{
    char buffer[256];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(buffer, sizeof(buffer), format, arguments);
    va_end(arguments);
    text += buffer;
}

void append_result(std::string& text, const Result& result)
{
    append(text, "%-7s %-8s %-9s %4d %-8s %8.1f %7.1f %8.1f %10.2f %6u %6u %6.1f %5u", result.core.c_str(),
           result.mode.c_str(), result.texel.c_str(), result.count.span, result.count.view.c_str(),
           result.instructions_per_pixel(), result.setup_per_pixel(), result.inner_per_pixel(),
           static_cast<double>(result.count.instructions) / 1e6, result.code_bytes, result.count.stack_bytes,
           result.accuracy.psnr_db, result.accuracy.worst_pixel);
    for (size_t i = 0; i < kChips; ++i) {
        if (kChipList[i].core == result.core)
            append(text, "  %s %.1f fps, %llu lines, %llu misses", kChipList[i].key,
                   frames_per_second(kChipList[i], result.count.instructions, result.traffic[i].misses),
                   static_cast<unsigned long long>(result.traffic[i].lines),
                   static_cast<unsigned long long>(result.traffic[i].misses));
    }
    text += "\n";
}

std::string chord_text(const Results& results)
{
    if (results.empty()) return "";
    std::string text =
        "instructions per covered pixel (whole frame, of it set-up, of it inner loop), M instructions a frame, bytes "
        "of code and stack,\nPSNR against exact in dB, worst pixel of 255; per part: frames a second, flash lines "
        "touched and missed a frame\n";
    append(text, "%-7s %-8s %-9s %4s %-8s %8s %7s %8s %10s %6s %6s %6s %5s\n", "core", "mode", "texel", "span", "view",
           "per px", "set-up", "inner", "M a frame", "code", "stack", "dB", "worst");
    for (const Result& result : results) append_result(text, result);
    return text;
}

void append_result(std::string& text, const SurfaceResult& result)
{
    const SurfaceCount& c = result.count;
    append(text, "%-7s %-11s %-6s %-8s %7.1f = %5.1f %5.1f %5.1f %6.1f %6.1f %6.1f %6.1f %6u %6u %7u %6.1f %5u",
           result.core.c_str(), c.mode.c_str(), result.pixel.c_str(), c.view.c_str(), c.per_pixel(c.instructions),
           c.per_pixel(c.palette + c.vertices), c.per_pixel(c.lists), c.per_pixel(c.lights), c.per_pixel(c.edges),
           c.per_pixel(c.samples), c.per_pixel(c.outlines), c.per_pixel(c.resolve), result.code_bytes, c.stack_bytes,
           c.ram_bytes, result.accuracy.psnr_db, result.accuracy.worst_pixel);
    for (size_t i = 0; i < kChips; ++i) {
        const Chip& chip = kChipList[i];
        const uint64_t misses = result.traffic[i].misses;
        if (chip.core != result.core) continue;
        append(text, "  %s %.1f", chip.key, frames_per_second(chip, c.instructions, misses));
        if (chip.cores == 2)
            append(text, " (both cores %.1f)", frames_per_second_of_two(chip, c.preparing(), c.instructions, misses));
        append(text, " fps, %llu misses", static_cast<unsigned long long>(misses));
    }
    text += "\n";
}

std::string surface_text(const SurfaceResults& surface)
{
    if (surface.results.empty()) return "";
    std::string text;
    append(text, "surface field %s: %u bytes, %u triangles, %u vertices\nsha256 %s\n", surface.field.name.c_str(),
           surface.field.bytes, surface.field.triangles, surface.field.vertices, surface.field.sha256.c_str());
    text +=
        "instructions per covered pixel (whole frame = vertices, lists of triangles, view tables, triangles and rows, "
        "samples, outlines, pixels),\nbytes of code, stack and RAM, PSNR against exact in dB, worst pixel of 255; per "
        "part: frames a second, flash lines missed a frame\n";
    append(text, "%-7s %-11s %-6s %-8s %7s = %5s %5s %5s %6s %6s %6s %6s %6s %6s %7s %6s %5s\n", "core", "mode",
           "pixel", "view", "per px", "vert", "lists", "views", "edges", "sample", "outl", "pixels", "code", "stack",
           "RAM", "dB", "worst");
    for (const SurfaceResult& result : surface.results) append_result(text, result);
    return text;
}

}  // namespace

std::string text_report(const Results& results, const SurfaceResults& surface)
{
    return chord_text(results) + surface_text(surface);
}

std::string json_report(const Results& results, const SurfaceResults& surface)
{
    ordered_json json = ordered_json::array();
    for (const Result& result : results) json.push_back(json_result(result));
    for (const SurfaceResult& result : surface.results) json.push_back(json_result(result, surface.field));
    return json.dump(1) + "\n";
}

}  // namespace lumi::bench
