// SPDX-License-Identifier: MIT
// A set-associative cache with least-recently-used replacement, fed with the addresses that a renderer reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "planner/chips.h"

namespace lumi::planner
{

// A read of `bytes` bytes at `address`.
struct Read {
    uint32_t address, bytes;
};

class CacheModel
{
public:
    explicit CacheModel(const CacheShape& shape);

    // A read that crosses into another line counts for both.
    void read(const Read& read);

    uint64_t misses() const { return misses_; }
    // Different lines read so far.
    size_t lines_touched() const { return touched_.size(); }

private:
    void touch(uint32_t line);

    CacheShape shape_;
    std::vector<uint32_t> lines_;  // per set, most recently used first
    std::unordered_set<uint32_t> touched_;
    uint64_t misses_ = 0;
};

struct Traffic {
    uint64_t lines = 0, misses = 0;
};
// Through the caches of kChipList.
using AllTraffic = std::array<Traffic, kChips>;
AllTraffic traffic_of(const std::vector<Read>& reads);

}  // namespace lumi::planner
