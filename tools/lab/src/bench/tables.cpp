// SPDX-License-Identifier: MIT
#include "bench/tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace lumi::bench
{
namespace
{

constexpr int kFastSpan = 16;

std::string per_pixel(const Result* result)
{
    return result == nullptr ? kNotMeasured : decimal_text(result->instructions_per_pixel(), 0);
}

// Runs over the modes and texels that were measured.
void for_each_renderer(const Results& results, const std::function<void(const std::string&, const std::string&)>& visit)
{
    for (const std::string& mode : kModes) {
        for (const std::string& texel : kTexels) {
            const auto is_it = [&](const Result& result) { return result.mode == mode && result.texel == texel; };
            if (std::any_of(results.begin(), results.end(), is_it)) visit(mode, texel);
        }
    }
}

// The spans of which there is a result.
std::vector<int> spans_of(const Results& results)
{
    std::vector<int> spans;
    for (const int span : kSpans) {
        const auto has_it = [&](const Result& result) { return result.count.span == span; };
        if (std::any_of(results.begin(), results.end(), has_it)) spans.push_back(span);
    }
    return spans;
}

// What a reader looks for first.
struct Glance {
    const char *mode, *texel;
    int span;
};
constexpr Glance kGlances[] = {
    {"nearest", "rgb565", 16}, {"linear", "luma8", 16}, {"linear", "palette8", 16}, {"linear", "rgb888", 16},
    {"paper", "rgb888", 16},   {"linear", "luma8", 8},  {"linear", "palette8", 8},  {"linear", "rgb888", 8},
};

std::string cost_of(const Result* result)
{
    return result == nullptr ? kNotMeasured : decimal_text(result->instructions_per_pixel());
}

std::string quality_of(const Result* result)
{
    return result == nullptr ? kNotMeasured : decimal_text(result->accuracy.psnr_db);
}

}  // namespace

std::string table_row(const std::vector<std::string>& cells)
{
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + cell + " |";
    return text + "\n";
}

std::string table_rule(size_t columns)
{
    std::string text = "|---|";
    for (size_t i = 1; i < columns; ++i) text += "---:|";
    return text + "\n";
}

std::string decimal_text(double value, int digits)
{
    if (std::isinf(value)) return "∞";
    char text[48];
    std::snprintf(text, sizeof(text), "%.*f", digits, value);
    return text;
}

std::string glance_table(const Results& results)
{
    const std::vector<std::string> titles = {"renderer", "M4", "M0+ code", "dB generic", "dB pole"};
    std::string text = table_row(titles) + table_rule(titles.size());
    for (const Glance& g : kGlances) {
        const Result* m4 = find_result(results, "m4", g.mode, g.texel, g.span, "generic");
        const Result* m0 = find_result(results, "m0plus", g.mode, g.texel, g.span, "generic");
        const Result* pole = find_result(results, "m4", g.mode, g.texel, g.span, "pole");
        text += table_row({std::string(g.mode) + " " + g.texel + ", S = " + std::to_string(g.span), cost_of(m4),
                           cost_of(m0), quality_of(m4), quality_of(pole)});
    }
    return text;
}

std::string cost_table(const Results& results)
{
    std::vector<std::string> titles = {"renderer"};
    for (const std::string& core : kCores)
        for (const int span : spans_of(results))
            titles.push_back(core + (span == 0 ? " exact" : " S" + std::to_string(span)));
    std::string text = table_row(titles) + table_rule(titles.size());
    for_each_renderer(results, [&](const std::string& mode, const std::string& texel) {
        std::vector<std::string> cells = {mode + " " + texel};
        for (const std::string& core : kCores)
            for (const int span : spans_of(results))
                cells.push_back(per_pixel(find_result(results, core, mode, texel, span, "generic")));
        text += table_row(cells);
    });
    return text;
}

std::string split_table(const Results& results)
{
    std::vector<std::string> titles = {"renderer"};
    for (const char* core : {"m4", "m0plus"})
        for (const char* span : {"8", "16"}) titles.push_back(std::string(core) + " S" + span + " set-up + inner");
    std::string text = table_row(titles) + table_rule(titles.size());
    for_each_renderer(results, [&](const std::string& mode, const std::string& texel) {
        std::vector<std::string> cells = {mode + " " + texel};
        for (const char* core : {"m4", "m0plus"}) {
            for (const int span : {8, kFastSpan}) {
                const Result* result = find_result(results, core, mode, texel, span, "generic");
                cells.push_back(result == nullptr ? kNotMeasured
                                                  : decimal_text(result->setup_per_pixel()) + " + " +
                                                        decimal_text(result->inner_per_pixel()));
            }
        }
        text += table_row(cells);
    });
    return text;
}

std::string accuracy_table(const Results& results)
{
    std::vector<std::string> titles = {"renderer"};
    for (const std::string& view : kViewNames)
        for (const int span : spans_of(results)) titles.push_back(view + " S" + std::to_string(span));
    std::string text = table_row(titles) + table_rule(titles.size());
    for_each_renderer(results, [&](const std::string& mode, const std::string& texel) {
        std::vector<std::string> cells = {mode + " " + texel};
        for (const std::string& view : kViewNames) {
            for (const int span : spans_of(results)) {
                const auto is_it = [&](const Result& r) {
                    return r.mode == mode && r.texel == texel && r.count.view == view && r.count.span == span;
                };
                const auto result = std::find_if(results.begin(), results.end(), is_it);
                cells.push_back(result == results.end() ? kNotMeasured
                                                        : decimal_text(result->accuracy.psnr_db) + " / " +
                                                              std::to_string(result->accuracy.worst_pixel));
            }
        }
        text += table_row(cells);
    });
    return text;
}

std::string memory_table(const Results& results)
{
    std::vector<std::string> titles = {"renderer"};
    for (const std::string& core : kCores) titles.push_back(core + " code / stack, bytes");
    std::string text = table_row(titles) + table_rule(titles.size());
    for_each_renderer(results, [&](const std::string& mode, const std::string& texel) {
        std::vector<std::string> cells = {mode + " " + texel};
        for (const std::string& core : kCores) {
            uint32_t stack_bytes = 0;
            for (const Result& result : results)
                if (result.core == core && result.mode == mode && result.texel == texel && result.count.span != 0)
                    stack_bytes = std::max(stack_bytes, result.count.stack_bytes);
            const Result* result = find_result(results, core, mode, texel, kFastSpan, "generic");
            cells.push_back(result == nullptr
                                ? kNotMeasured
                                : std::to_string(result->code_bytes) + " / " + std::to_string(stack_bytes));
        }
        text += table_row(cells);
    });
    return text;
}

std::string chip_table(const Results& results)
{
    std::vector<std::string> titles = {"renderer, S = 16"};
    for (const Chip& chip : kChipList) titles.push_back(std::string(chip.title) + ": lines, misses, frames/s");
    std::string text = table_row(titles) + table_rule(titles.size());
    for_each_renderer(results, [&](const std::string& mode, const std::string& texel) {
        std::vector<std::string> cells = {mode + " " + texel};
        for (size_t i = 0; i < kChips; ++i) {
            const Chip& chip = kChipList[i];
            const Result* result = find_result(results, chip.core, mode, texel, kFastSpan, "generic");
            if (result == nullptr) {
                cells.push_back(kNotMeasured);
                continue;
            }
            const Traffic& traffic = result->traffic[i];
            cells.push_back(std::to_string(traffic.lines) + ", " + std::to_string(traffic.misses) + ", **" +
                            decimal_text(frames_per_second(chip, result->count.instructions, traffic.misses)) + "**");
        }
        text += table_row(cells);
    });
    return text;
}

std::string polar_table(const Results& results)
{
    std::vector<std::string> titles = {"renderer, S = 16"};
    for (const std::string& core : kCores) titles.push_back(core + " generic → pole");
    std::string text = table_row(titles) + table_rule(titles.size());
    for_each_renderer(results, [&](const std::string& mode, const std::string& texel) {
        std::vector<std::string> cells = {mode + " " + texel};
        for (const std::string& core : kCores) {
            const Result* generic = find_result(results, core, mode, texel, kFastSpan, "generic");
            const Result* pole = find_result(results, core, mode, texel, kFastSpan, "pole");
            if (generic == nullptr || pole == nullptr) {
                cells.push_back(kNotMeasured);
                continue;
            }
            const double change = 100 * (pole->instructions_per_pixel() / generic->instructions_per_pixel() - 1);
            cells.push_back(per_pixel(generic) + " → " + per_pixel(pole) + " (" + (change < 0 ? "" : "+") +
                            decimal_text(change) + " %)");
        }
        text += table_row(cells);
    });
    return text;
}

std::string baseline_cost_table(const Results& results, const std::vector<BaselineCost>& costs)
{
    const std::vector<std::string> titles = {"method", "core", "instructions a covered pixel", "M instructions a frame",
                                             "code, bytes"};
    std::string text = table_row(titles) + table_rule(titles.size());
    for (const BaselineCost& cost : costs) {
        const auto instructions = static_cast<double>(cost.count.instructions);
        text += table_row({cost.title, cost.core, decimal_text(instructions / static_cast<double>(cost.count.covered)),
                           decimal_text(instructions / 1e6, 2), std::to_string(cost.code_bytes)});
    }
    for (const char* mode : {"nearest", "linear", "paper"}) {
        for (const std::string& core : kCores) {
            const Result* result = find_result(results, core, mode, "rgb565", kFastSpan, "generic");
            if (result == nullptr) continue;
            text += table_row({std::string("this library, ") + mode + ", S = 16", core,
                               decimal_text(result->instructions_per_pixel()),
                               decimal_text(static_cast<double>(result->count.instructions) / 1e6, 2),
                               std::to_string(result->code_bytes)});
        }
    }
    return text;
}

std::string likeness_table(const std::vector<Likeness>& pictures)
{
    std::vector<std::string> titles = {"method", "flash, MB"};
    for (const std::string& view : kViewNames) titles.push_back(view + ", dB / SSIM");
    std::string text = table_row(titles) + table_rule(titles.size());
    for (const Likeness& picture : pictures) {
        std::vector<std::string> cells = {picture.title,
                                          decimal_text(static_cast<double>(picture.flash_bytes) / 1e6, 2)};
        for (size_t v = 0; v < kViewNames.size(); ++v)
            cells.push_back(decimal_text(picture.psnr_db[v]) + " / " + decimal_text(picture.ssim[v], 3));
        text += table_row(cells);
    }
    return text;
}

}  // namespace lumi::bench
