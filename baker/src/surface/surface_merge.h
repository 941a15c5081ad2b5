// SPDX-License-Identifier: MIT
// Joins the shards of a surface bake.
#pragma once

#include "lumi/baker/merge.h"
#include "store/shard_set.h"

namespace lumi::baker
{

// Throws what merge_shards throws.
MergedField merge_surface(ShardSet& set, const std::filesystem::path& output,
                          const std::function<void()>& leave_if_cancelled);

}  // namespace lumi::baker
