// SPDX-License-Identifier: MIT
#include "guided/chart_blocks.h"

#include <catch2/catch.hpp>

#include "guided/block_book.h"
#include "math/sampler.h"

namespace lumi::baker::testing
{
namespace
{

const ProgressCallback kSilent;

TexelBlock block_of(const std::array<float, 4>& levels, uint32_t known = 15)
{
    TexelBlock block;
    for (size_t corner = 0; corner < 4; ++corner) {
        if ((known >> corner & 1) != 0) {
            block.set(corner, {levels[corner], 0, -levels[corner]});
        }
    }
    return block;
}

ChartRows rows_of(uint32_t first_v, const std::vector<std::array<uint32_t, 2>>& first_and_count)
{
    ChartRows rows;
    rows.first_v = first_v;
    for (const auto& [first, count] : first_and_count) {
        rows.rows.push_back({first, count, rows.texel_count});
        rows.texel_count += count;
    }
    return rows;
}

// Smooth colours with noise, and some texels missing.
ChartColours colours_over(const ChartRows& rows, uint32_t origin)
{
    ChartColours chart;
    Sampler sampler(3, origin, 0);
    for (size_t r = 0; r < rows.rows.size(); ++r) {
        for (uint32_t k = 0; k < rows.rows[r].count; ++k) {
            const float u = static_cast<float>(rows.rows[r].first_u + k), v = static_cast<float>(rows.first_v + r);
            sampler.start(static_cast<uint32_t>(chart.levels.size()));
            chart.levels.push_back({u - 20, v - 20 + 4 * sampler.next_1d(), 30 * sampler.next_1d()});
            chart.known.push_back(sampler.next_1d() < 0.9f ? 1 : 0);
        }
    }
    return chart;
}

// The entry that a grid point shows, in colours of its group; 0 to 3: missing.
size_t entry_at(const ChartRows& blocks, const std::vector<uint8_t>& texels, uint32_t u, uint32_t v)
{
    const ChartRows::Row& row = blocks.rows[v / 2 - blocks.first_v];
    REQUIRE(u / 2 >= row.first_u);
    REQUIRE(u / 2 - row.first_u < row.count);
    return size_t{4} * texels[row.at + u / 2 - row.first_u] + 2 * (v % 2) + u % 2;
}

}  // namespace

TEST_CASE("blocks that lie apart have entries of their own", "[guided]")
{
    std::vector<TexelBlock> blocks;
    for (int k = 0; k < 90; ++k) {
        const float base = static_cast<float>(40 * (k % 3));
        blocks.push_back(block_of({base, base + 5, base, base - 5}));
    }
    const BlockBook book = block_book(blocks, 255, 1);
    REQUIRE(book.size() == 3);
    for (const TexelBlock& block : blocks) {
        CHECK(distance2(book[nearest_entry(book, block)], block) < 1e-3f);
    }
    CHECK(block_book({}, 255, 1).empty());
}

TEST_CASE("a corner that is not known moves no entry and asks for none", "[guided]")
{
    std::vector<TexelBlock> blocks(20, block_of({10, 10, 10, 10}));
    blocks.push_back(block_of({10, 10, 0, 0}, 3));
    const BlockBook book = block_book(blocks, 255, 1);
    REQUIRE(book.size() == 1);
    CHECK(book[0][0] == Approx(10));
    CHECK(book[0][9] == Approx(10));
    CHECK(book[0][11] == Approx(-10));
    CHECK(block_of({8, 4, 0, 0}, 3).filled()[6] == Approx(6));
    CHECK(block_of({8, 4, 0, 0}, 3).known_count() == 2);
}

TEST_CASE("rows of blocks cover the rows of texels", "[guided]")
{
    const ChartRows blocks = block_rows(rows_of(5, {{7, 3}, {4, 2}, {0, 0}, {0, 0}, {0, 0}, {3, 6}}));
    REQUIRE(blocks.first_v == 2);
    REQUIRE(blocks.rows.size() == 4);
    CHECK(blocks.rows[0].first_u == 3);  // grid row 5 alone: 7 to 9
    CHECK(blocks.rows[0].count == 2);
    CHECK(blocks.rows[1].first_u == 2);  // 6 and 7: 4 to 5
    CHECK(blocks.rows[1].count == 1);
    CHECK(blocks.rows[2].count == 0);
    CHECK(blocks.rows[3].first_u == 1);  // 10: 3 to 8
    CHECK(blocks.rows[3].count == 4);
    CHECK(blocks.rows[3].at == 3);
    CHECK(blocks.texel_count == 7);
    CHECK(block_rows(ChartRows()).rows.empty());
}

TEST_CASE("texels in blocks are near to what they should show, for any number of threads", "[guided]")
{
    std::vector<ChartRows> rows;
    std::vector<ChartColours> charts;
    for (uint32_t origin = 0; origin < 3; ++origin) {
        rows.push_back(rows_of(3 + origin, std::vector<std::array<uint32_t, 2>>(40, {1 + origin, 41})));
        charts.push_back(colours_over(rows.back(), origin));
    }
    Job one(1, 1, kSilent), four(1, 4, kSilent);
    const Palettes palettes = blocks_of(charts, rows, true, one), again = blocks_of(charts, rows, true, four);
    CHECK(palettes.colours == again.colours);
    CHECK(palettes.texels == again.texels);
    CHECK(palettes.origins_per_palette == 3);
    REQUIRE(palettes.colours.size() == 4096);
    double sum = 0;
    size_t known = 0;
    for (size_t origin = 0; origin < 3; ++origin) {
        const ChartRows blocks = block_rows(rows[origin]);
        REQUIRE(palettes.texels[origin].size() == blocks.texel_count);
        for (size_t r = 0; r < rows[origin].rows.size(); ++r) {
            for (uint32_t k = 0; k < 41; ++k) {
                const size_t number = rows[origin].rows[r].at + k;
                const uint32_t v = rows[origin].first_v + static_cast<uint32_t>(r);
                const size_t entry = entry_at(blocks, palettes.texels[origin], rows[origin].rows[r].first_u + k, v);
                if (charts[origin].known[number] == 0) {
                    continue;
                }
                REQUIRE(entry >= 4);
                const float shown = static_cast<int8_t>(palettes.colours[4 * entry]);
                sum += static_cast<double>(std::abs(shown - charts[origin].levels[number].r));
                ++known;
            }
        }
    }
    CHECK(sum / static_cast<double>(known) < 4);  // of a range of 40
    for (size_t k = 0; k < 16; ++k) {
        CHECK(palettes.colours[k] == 0);
    }
}

}  // namespace lumi::baker::testing
