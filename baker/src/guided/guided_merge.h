// SPDX-License-Identifier: MIT
// Joins the shards of a guided bake.
#pragma once

#include "lumi/baker/merge.h"
#include "store/shard_set.h"

namespace lumi::baker
{

// Checks all shards, fits the palettes, writes `output`. Memory: all charts. Throws as merge_shards does.
MergedField merge_guided(ShardSet& set, const std::filesystem::path& output,
                         const std::function<void()>& leave_if_cancelled);

}  // namespace lumi::baker
