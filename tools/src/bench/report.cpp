// SPDX-License-Identifier: MIT
#include "bench/report.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>


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

ordered_json json_row(const Row& row)
{
    ordered_json json;
    json["core"] = row.core;
    json["mode"] = row.mode;
    json["texel"] = row.texel;
    json["span"] = row.count.span;
    json["view"] = row.count.view;
    json["instructions_per_pixel"] = hundredths(row.instructions_per_pixel());
    json["setup"] = hundredths(row.setup_per_pixel());
    json["inner"] = hundredths(row.inner_per_pixel());
    json["instructions_per_frame"] = row.count.instructions;
    json["covered_pixels"] = row.count.covered;
    json["code_bytes"] = row.code_bytes;
    json["stack_bytes"] = row.count.stack_bytes;
    json["psnr_db"] = decibels(row.accuracy.psnr_db);
    json["psnr_all_db"] = decibels(row.accuracy.psnr_all_db);
    json["worst_pixel"] = row.accuracy.worst_pixel;
    for (size_t i = 0; i < kChips; ++i) {
        json[std::string("lines_") + kChipList[i].key] = row.traffic[i].lines;
        json[std::string("misses_") + kChipList[i].key] = row.traffic[i].misses;
    }
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

void append_row(std::string& text, const Row& row)
{
    append(text, "%-7s %-8s %-9s %4d %-8s %8.1f %7.1f %8.1f %10.2f %6u %6u %6.1f %5u", row.core.c_str(),
           row.mode.c_str(), row.texel.c_str(), row.count.span, row.count.view.c_str(), row.instructions_per_pixel(),
           row.setup_per_pixel(), row.inner_per_pixel(), static_cast<double>(row.count.instructions) / 1e6,
           row.code_bytes, row.count.stack_bytes, row.accuracy.psnr_db, row.accuracy.worst_pixel);
    for (size_t i = 0; i < kChips; ++i) {
        if (kChipList[i].core == row.core)
            append(text, "  %s %.1f fps, %llu lines, %llu misses", kChipList[i].key,
                   frames_per_second(kChipList[i], row.count.instructions, row.traffic[i].misses),
                   static_cast<unsigned long long>(row.traffic[i].lines),
                   static_cast<unsigned long long>(row.traffic[i].misses));
    }
    text += "\n";
}

}  // namespace

std::string text_report(const Rows& rows)
{
    std::string text =
        "instructions per covered pixel (whole frame, of it set-up, of it inner loop), M instructions a frame, bytes "
        "of "
        "code and stack,\nPSNR against exact in dB, worst pixel of 255; per part: frames a second, flash lines touched "
        "and missed a frame\n";
    append(text, "%-7s %-8s %-9s %4s %-8s %8s %7s %8s %10s %6s %6s %6s %5s\n", "core", "mode", "texel", "span", "view",
           "per px", "set-up", "inner", "M a frame", "code", "stack", "dB", "worst");
    for (const Row& row : rows) append_row(text, row);
    return text;
}

std::string json_report(const Rows& rows)
{
    ordered_json json = ordered_json::array();
    for (const Row& row : rows) json.push_back(json_row(row));
    return json.dump(1) + "\n";
}

}  // namespace lumi::bench
