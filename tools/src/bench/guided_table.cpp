// SPDX-License-Identifier: MIT
#include <algorithm>

#include "bench/guided.h"
#include "bench/tables.h"

namespace lumi::bench
{
namespace
{

const std::string kNotMeasured = "–";

std::string whole_and_surface(const Row* row)
{
    if (row == nullptr) return kNotMeasured;
    return decimal_text(row->instructions_per_pixel(), 0) + " / " + decimal_text(row->setup_per_pixel(), 0);
}

// The rows of one core and view tell which renderers there are: a core draws them all.
std::vector<const Row*> guided_renderers(const Rows& rows)
{
    std::vector<const Row*> renderers;
    for (const Row& row : rows) {
        const auto is_same = [&](const Row* known) { return known->mode == row.mode && known->texel == row.texel; };
        if (is_guided(row.mode) && std::none_of(renderers.begin(), renderers.end(), is_same)) renderers.push_back(&row);
    }
    return renderers;
}

}  // namespace

std::string guided_table(const Rows& rows)
{
    const std::vector<const Row*> renderers = guided_renderers(rows);
    if (renderers.empty()) return "";
    std::vector<std::string> titles = {"renderer"};
    for (const std::string& core : kCores) titles.push_back(core);
    for (const std::string& view : kViewNames) titles.push_back(view + ", dB / worst");
    titles.push_back("m0plus code / stack, bytes");
    std::string text = table_row(titles) + table_rule(titles.size());
    for (const Row* of : renderers) {
        std::vector<std::string> cells = {of->mode + " " + of->texel};
        for (const std::string& core : kCores)
            cells.push_back(whole_and_surface(find_row(rows, core, of->mode, of->texel, 0, "generic")));
        for (const std::string& view : kViewNames) {
            const Row* row = find_row(rows, of->core, of->mode, of->texel, 0, view);
            cells.push_back(row == nullptr ? kNotMeasured
                                           : decimal_text(row->accuracy.psnr_db) + " / " +
                                                 std::to_string(row->accuracy.worst_pixel));
        }
        const Row* small = find_row(rows, "m0plus", of->mode, of->texel, 0, "generic");
        cells.push_back(small == nullptr
                            ? kNotMeasured
                            : std::to_string(small->code_bytes) + " / " + std::to_string(small->count.stack_bytes));
        text += table_row(cells);
    }
    return text;
}

}  // namespace lumi::bench
