// SPDX-License-Identifier: MIT
// The shards that are to be merged, and what is wrong with them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lumi/baker/bake.h"
#include "store/block_file.h"

namespace lumi::baker
{

// Which rows each shard of a bake gets.

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

class ShardSet
{
public:
    // Throws BakeError for settings or shards that cannot be.
    using RequirePossible = void (*)(const BakeIdentity& identity);

    // Opens all, and sorts out those that do not belong to the bake of most.
    ShardSet(const std::vector<std::filesystem::path>& files, RequirePossible require_possible);

    // Those that belong together, by index, from 1.
    const std::map<uint32_t, BlockFile*>& shards() const { return shards_; }
    bool is_surface() const { return !shards_.empty() && shards_.begin()->second->identity().is_surface(); }
    uint32_t count() const { return shards_.begin()->second->identity().shard.count; }
    const AnySettings& settings() const { return shards_.begin()->second->identity().settings; }

    // These note problems of the contents.
    void say(const std::filesystem::path& file, const std::string& text);
    void say_missing(const std::filesystem::path& file, size_t missing, uint32_t all, uint32_t first_origin);
    // Throws MergeError if there is any problem, a missing shard among them.
    void throw_problems();

private:
    void open(const std::filesystem::path& file, RequirePossible require_possible);
    const BlockFile& most_common() const;
    void sort_out(const BlockFile& model);
    void name_missing();

    std::vector<std::unique_ptr<BlockFile>> opened_;
    std::map<uint32_t, BlockFile*> shards_;
    std::vector<std::string> problems_;
};

// The message about a shard that was intact a moment ago.
std::string changed_meanwhile(const std::filesystem::path& file);

}  // namespace lumi::baker
