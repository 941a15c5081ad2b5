// SPDX-License-Identifier: MIT
#include "store/shard_rows.h"

#include "lumi/detail/lattice.h"

namespace lumi::baker
{
namespace
{

// A fixed lot for each round: the top bits of a multiplicative hash, scaled to 0 .. shards - 1.
uint32_t turn(uint32_t round, uint32_t shards)
{
    uint32_t h = (round + 1) * 0x9E3779B9u;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h ^= h >> 13;
    return static_cast<uint32_t>(static_cast<uint64_t>(h) * shards >> 32);
}

}  // namespace

void check_shard(const Shard& shard)
{
    if (shard.count < 1 || shard.count > detail::kMaxLatticeSize || shard.index < 1 || shard.index > shard.count) {
        throw BakeError("there is no shard " + std::to_string(shard.index) + " of " + std::to_string(shard.count) +
                        "; shards are counted from 1");
    }
}

uint32_t ShardRows::index_of(uint32_t row, uint32_t shards)
{
    return (row % shards + turn(row / shards, shards)) % shards + 1;
}

uint32_t ShardRows::row(uint32_t slot) const
{
    const uint32_t n = shard_.count;
    return slot * n + (shard_.index - 1 + n - turn(slot, n)) % n;
}

uint32_t ShardRows::size() const
{
    const uint32_t whole_rounds = rows_ / shard_.count;
    return whole_rounds + (rows_ % shard_.count != 0 && row(whole_rounds) < rows_ ? 1 : 0);
}

}  // namespace lumi::baker
