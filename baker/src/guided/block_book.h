// SPDX-License-Identifier: MIT
// Clusters of blocks of four colours.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lumi::baker
{

using BlockColours = std::array<float, 12>;  // r, g, b of corner 0, of corner 1, ...

class TexelBlock
{
public:
    void set(size_t corner, const std::array<float, 3>& colour);

    bool known(size_t corner) const { return (known_ >> corner & 1) != 0; }
    size_t known_count() const;
    const BlockColours& colours() const { return colours_; }  // 0 where they are not known
    BlockColours filled() const;                              // the mean of the known ones where they are not

private:
    BlockColours colours_{};
    uint32_t known_ = 0;
};

using BlockBook = std::vector<BlockColours>;

// The squared distance of the corners that are known.
float distance2(const BlockColours& entry, const TexelBlock& block);
// The lowest of equally near ones; `book` is not empty. Cost: a distance to each.
size_t nearest_entry(const BlockBook& book, const TexelBlock& block);

// k-means with k-means++ seeding of blocks with a known corner each: `count` entries, or fewer where that many
// different blocks are not there. The same blocks, in the same order, give the same entries.
BlockBook block_book(const std::vector<TexelBlock>& blocks, size_t count, uint64_t seed);

}  // namespace lumi::baker
