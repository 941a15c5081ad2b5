// SPDX-License-Identifier: MIT
#include "guided/chart_blocks.h"

#include "guided/block_book.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kSeed = 0x626C6F63;
constexpr size_t kFitBlocks = 32768;  // that a group's blocks are fitted to
constexpr size_t kBlocks = 255;       // of a group; number 0 is the missing one

struct Columns {
    uint32_t first, end;  // of blocks
};

// Of the blocks over grid rows 2b and 2b + 1, of which either may be absent.
Columns columns_over(const ChartRows::Row* upper, const ChartRows::Row* lower)
{
    Columns columns = {UINT32_MAX, 0};
    for (const ChartRows::Row* row : {upper, lower}) {
        if (row != nullptr && row->count != 0) {
            columns.first = std::min(columns.first, row->first_u / 2);
            columns.end = std::max(columns.end, (row->first_u + row->count + 1) / 2);
        }
    }
    return columns.end == 0 ? Columns{0, 0} : columns;
}

const ChartRows::Row* row_at(const ChartRows& rows, uint32_t v)
{
    return v >= rows.first_v && v - rows.first_v < rows.rows.size() ? &rows.rows[v - rows.first_v] : nullptr;
}

void put_texel(const ChartColours& chart, const ChartRows::Row* row, uint32_t u, size_t corner, TexelBlock& block)
{
    if (row == nullptr || u < row->first_u || u - row->first_u >= row->count) {
        return;
    }
    const size_t number = row->at + (u - row->first_u);
    if (chart.known[number] != 0) {
        const Levels& c = chart.levels[number];
        block.set(corner, {c.r, c.g, c.b});
    }
}

std::vector<TexelBlock> blocks_in(const ChartColours& chart, const ChartRows& rows)
{
    std::vector<TexelBlock> blocks;
    const ChartRows in_blocks = block_rows(rows);
    for (size_t b = 0; b < in_blocks.rows.size(); ++b) {
        const uint32_t v = 2 * (in_blocks.first_v + static_cast<uint32_t>(b));
        for (uint32_t k = 0; k < in_blocks.rows[b].count; ++k) {
            const uint32_t u = 2 * (in_blocks.rows[b].first_u + k);
            TexelBlock block;
            for (uint32_t corner = 0; corner < 4; ++corner) {
                put_texel(chart, row_at(rows, v + corner / 2), u + corner % 2, corner, block);
            }
            blocks.push_back(block);
        }
    }
    return blocks;
}

BlockBook fitted_book(const std::vector<std::vector<TexelBlock>>& charts, bool differences)
{
    std::vector<TexelBlock> known;
    for (const std::vector<TexelBlock>& chart : charts) {
        std::copy_if(chart.begin(), chart.end(), std::back_inserter(known),
                     [](const TexelBlock& block) { return block.known_count() != 0; });
    }
    const size_t step = known.size() / kFitBlocks + 1;
    std::vector<TexelBlock> chosen;
    for (size_t k = 0; k < known.size(); k += step) {
        chosen.push_back(known[k]);
    }
    BlockBook book = block_book(chosen, kBlocks, kSeed);
    const float low = differences ? -128 : 0, high = differences ? 127 : 255;
    for (BlockColours& entry : book) {
        for (float& channel : entry) {
            channel = std::round(std::clamp(channel, low, high));
        }
    }
    return book;
}

// The place of an entry's bytes is 4 · number of the block + corner, in colours.
void put_book(const BlockBook& book, uint8_t* out)
{
    for (const BlockColours& entry : book) {
        out += 4 * format::kChartColourBytes;
        for (size_t k = 0; k < entry.size(); ++k) {
            out[k / 3 * format::kChartColourBytes + k % 3] = static_cast<uint8_t>(static_cast<int>(entry[k]));
        }
    }
}

}  // namespace

ChartRows block_rows(const ChartRows& rows)
{
    ChartRows result;
    result.first_v = rows.first_v / 2;
    const uint32_t end = rows.rows.empty() ? 0 : (rows.first_v + static_cast<uint32_t>(rows.rows.size()) + 1) / 2;
    for (uint32_t b = result.first_v; b < end; ++b) {
        const Columns columns = columns_over(row_at(rows, 2 * b), row_at(rows, 2 * b + 1));
        result.rows.push_back({columns.first, columns.end - columns.first, result.texel_count});
        result.texel_count += result.rows.back().count;
    }
    return result;
}

Palettes blocks_of(const std::vector<ChartColours>& charts, const std::vector<ChartRows>& rows, bool differences,
                   Job& job)
{
    uint64_t texels = 0;
    for (const ChartColours& chart : charts) {
        texels += chart.levels.size();
    }
    Palettes result;
    result.origins_per_palette = origins_per_palette(texels, charts.size(), format::GuidedTexel::vq8);
    const size_t group_bytes = size_t{format::chart_colours(format::GuidedTexel::vq8)} * format::kChartColourBytes;
    const size_t per_group = result.origins_per_palette, groups = (charts.size() + per_group - 1) / per_group;
    result.colours.resize(groups * group_bytes);
    result.texels.resize(charts.size());
    job.run(static_cast<uint32_t>(groups), [&](uint32_t g) {
        const size_t first = g * per_group, end = std::min(charts.size(), first + per_group);
        std::vector<std::vector<TexelBlock>> blocks;
        for (size_t origin = first; origin < end; ++origin) {
            blocks.push_back(blocks_in(charts[origin], rows[origin]));
        }
        const BlockBook book = fitted_book(blocks, differences);
        put_book(book, &result.colours[g * group_bytes]);
        for (size_t origin = first; origin < end; ++origin) {
            for (const TexelBlock& block : blocks[origin - first]) {
                const bool known = block.known_count() != 0;
                result.texels[origin].push_back(known ? static_cast<uint8_t>(1 + nearest_entry(book, block)) : 0);
            }
        }
    });
    return result;
}

}  // namespace lumi::baker
