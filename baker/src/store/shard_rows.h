// SPDX-License-Identifier: MIT
// Which rows each shard of a bake gets.
#pragma once

#include "lumi/baker/bake.h"

namespace lumi::baker
{

// Throws BakeError.
void check_shard(const Shard& shard);

// Shards deal the rows in rounds of `count` rows, one to each, turned by lot: a fixed turn would resonate with the
// lattice, whose points i and i + F (F a Fibonacci number) are neighbours.
class ShardRows
{
public:
    ShardRows(uint32_t rows, const Shard& shard) : rows_(rows), shard_(shard) {}

    uint32_t size() const;
    uint32_t row(uint32_t slot) const;

    static uint32_t slot_of(uint32_t row, uint32_t shards) { return row / shards; }
    static uint32_t index_of(uint32_t row, uint32_t shards);  // the shard that holds the row, counted from 1

private:
    uint32_t rows_;
    Shard shard_;
};

}  // namespace lumi::baker
