// SPDX-License-Identifier: MIT
#include "chord/bake_layout.h"

#include "lumi/lattice.h"

namespace lumi::baker
{
namespace
{

void require(bool good, const std::string& message)
{
    if (!good) {
        throw BakeError(message);
    }
}

std::string lattice_range(const char* name)
{
    return std::string("the number of ") + name + " must lie in 1 to " + std::to_string(kMaxLatticeSize);
}

// A fixed lot for each round: the top bits of a multiplicative hash, scaled to 0 .. shards - 1.
uint32_t turn(uint32_t round, uint32_t shards)
{
    uint32_t h = (round + 1) * 0x9E3779B9u;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h ^= h >> 13;
    return static_cast<uint32_t>(uint64_t{h} * shards >> 32);
}

}  // namespace

FieldLayout checked_layout(const BakeSettings& s)
{
    require(s.origins >= 1 && s.origins <= kMaxLatticeSize, lattice_range("origins"));
    require(s.directions >= 1 && s.directions <= kMaxLatticeSize, lattice_range("directions"));
    require(s.used_origins <= s.origins, "the cap holds " + std::to_string(s.used_origins) + " origins of " +
                                             std::to_string(s.origins) + "; choose at most all of them, or 0 for all");
    require(s.samples >= 1, "the number of samples must be at least 1");
    require(s.max_error_levels >= 0 && s.max_error_levels <= 255,
            "the error at which a texel is settled must lie in 0 to 255 levels");
    require(static_cast<uint32_t>(s.texel) < format::kTexelFormats, "there is no such texel format");
    require(s.footprint <= Footprint::both, "there is no such footprint");
    const FieldLayout layout = {s.origins, s.directions, s.used_origins ? s.used_origins : s.origins, s.texel, {}, 1};
    require(file_bytes(layout) <= UINT32_MAX, "the field would have " + std::to_string(file_bytes(layout)) +
                                                  " bytes, and a field file holds less than 4 GiB; choose fewer "
                                                  "origins or directions, a smaller cap or a smaller texel format");
    return layout;
}

void check_shard(const Shard& shard)
{
    require(shard.count >= 1 && shard.count <= kMaxLatticeSize && shard.index >= 1 && shard.index <= shard.count,
            "there is no shard " + std::to_string(shard.index) + " of " + std::to_string(shard.count) +
                "; shards are counted from 1");
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
