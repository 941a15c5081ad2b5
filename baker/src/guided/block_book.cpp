// SPDX-License-Identifier: MIT
// k-means++ seeding: Arthur & Vassilvitskii, "k-means++: The Advantages of Careful Seeding", SODA 2007.
#include "guided/block_book.h"

#include <algorithm>
#include <limits>

#include "image/k_means.h"

namespace lumi::baker
{
namespace
{

constexpr int kIterations = 12;  // the error falls by less than 1 % an iteration from there on

// Each further entry is drawn with probability proportional to the squared distance from those already there.
BlockBook seeded(const std::vector<TexelBlock>& blocks, size_t count, uint64_t seed)
{
    BlockBook book;
    std::vector<float> distances(blocks.size(), 1);
    Sampler sampler(seed, 0, 0);
    while (book.size() < count) {
        const std::optional<size_t> chosen = drawn_by_distance(distances, sampler);
        if (!chosen) {
            break;  // every block has an entry of its own
        }
        book.push_back(blocks[*chosen].filled());
        for (size_t k = 0; k < blocks.size(); ++k) {
            const float d = distance2(book.back(), blocks[k]);
            distances[k] = book.size() == 1 ? d : std::min(distances[k], d);
        }
    }
    return book;
}

// The colours of the blocks nearest to an entry, corner by corner.
struct Cluster {
    std::array<double, 12> sum{};
    std::array<double, 4> count{};

    void add(const TexelBlock& block)
    {
        for (size_t k = 0; k < sum.size(); ++k) {
            sum[k] += static_cast<double>(block.colours()[k]);
        }
        for (size_t corner = 0; corner < count.size(); ++corner) {
            count[corner] += block.known(corner) ? 1 : 0;
        }
    }
};

// Moves each entry to the mean of the blocks nearest to it.
void refine(BlockBook& book, const std::vector<TexelBlock>& blocks)
{
    std::vector<Cluster> clusters(book.size());
    for (const TexelBlock& block : blocks) {
        clusters[nearest_entry(book, block)].add(block);
    }
    for (size_t e = 0; e < book.size(); ++e) {
        for (size_t k = 0; k < book[e].size(); ++k) {
            if (clusters[e].count[k / 3] > 0) {
                book[e][k] = static_cast<float>(clusters[e].sum[k] / clusters[e].count[k / 3]);
            }
        }
    }
}

}  // namespace

void TexelBlock::set(size_t corner, const std::array<float, 3>& colour)
{
    std::copy(colour.begin(), colour.end(), colours_.begin() + static_cast<std::ptrdiff_t>(3 * corner));
    known_ |= 1u << corner;
}

size_t TexelBlock::known_count() const
{
    size_t count = 0;
    for (size_t corner = 0; corner < 4; ++corner) {
        count += known(corner) ? 1u : 0u;
    }
    return count;
}

BlockColours TexelBlock::filled() const
{
    BlockColours result = colours_;
    const auto count = static_cast<float>(known_count());
    for (size_t k = 0; k < result.size(); ++k) {
        if (!known(k / 3)) {
            result[k] = (colours_[k % 3] + colours_[k % 3 + 3] + colours_[k % 3 + 6] + colours_[k % 3 + 9]) / count;
        }
    }
    return result;
}

float distance2(const BlockColours& entry, const TexelBlock& block)
{
    float sum = 0;
    for (size_t k = 0; k < entry.size(); ++k) {
        const float d = block.known(k / 3) ? entry[k] - block.colours()[k] : 0;
        sum += d * d;
    }
    return sum;
}

size_t nearest_entry(const BlockBook& book, const TexelBlock& block)
{
    size_t best = 0;
    float least = std::numeric_limits<float>::infinity();
    for (size_t e = 0; e < book.size(); ++e) {
        const float d = distance2(book[e], block);
        if (d < least) {
            best = e;
            least = d;
        }
    }
    return best;
}

BlockBook block_book(const std::vector<TexelBlock>& blocks, size_t count, uint64_t seed)
{
    BlockBook book = seeded(blocks, count, seed);
    for (int k = 0; k < kIterations; ++k) {
        refine(book, blocks);
    }
    return book;
}

}  // namespace lumi::baker
