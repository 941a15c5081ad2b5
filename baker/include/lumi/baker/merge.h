// SPDX-License-Identifier: MIT
// Joins the shard files of a bake into its field.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lumi/baker/bake.h"
#include "lumi/baker/progress.h"

namespace lumi::baker
{

// Everything that is wrong with a set of shards; each problem reads "file: what is wrong; how to mend it", or
// "shards 2, 5 of 8 are missing; how to mend it".
struct MergeError : BakeError {
    explicit MergeError(std::vector<std::string> all);
    std::vector<std::string> problems;
};

struct MergedField {
    uint64_t bytes = 0;
    uint32_t origins = 0, directions = 0;  // 0 for a surface field
    uint32_t shards = 0;
};

// Writes `output`, bit-identical to what bake_field or bake_surface would. The shards may come in any order. Before the
// first byte is written every row of every shard is checked. Throws MergeError for missing, double, foreign, stale or
// damaged shards, FileClash where the output is one of them, BakeError if it cannot be written, Cancelled once
// `keep_going` returns false; an earlier output then stays as it was. Memory: one row.
MergedField merge_shards(const std::vector<std::filesystem::path>& shards, const std::filesystem::path& output,
                         const std::function<bool()>& keep_going = {});

}  // namespace lumi::baker
