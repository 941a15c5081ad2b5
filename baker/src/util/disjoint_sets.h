// SPDX-License-Identifier: MIT
// Sets of numbers that are joined one by one (union-find).
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace lumi::baker
{

class DisjointSets
{
public:
    // Each number below `count` is a set of its own.
    explicit DisjointSets(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    // All members of a set have the same number.
    uint32_t root(uint32_t number)
    {
        while (parent_[number] != number) number = parent_[number] = parent_[parent_[number]];
        return number;
    }
    void join(uint32_t a, uint32_t b) { parent_[root(a)] = root(b); }

private:
    std::vector<uint32_t> parent_;
};

}  // namespace lumi::baker
