// SPDX-License-Identifier: MIT
#include "lumi/baker/merge.h"

#include "chord/bake_layout.h"
#include "chord/chord_merge.h"
#include "lumi/baker/file_guard.h"
#include "store/settings_codec.h"
#include "store/shard_rows.h"
#include "surface/surface_merge.h"

namespace lumi::baker
{
namespace
{

namespace fs = std::filesystem;

void require_possible_identity(const BakeIdentity& id)
{
    if (const SurfaceSettings* surface = std::get_if<SurfaceSettings>(&id.settings)) {
        require_possible_surface(*surface);
        check_shard(id.shard);
    } else {
        layout_of(id);
    }
}

}  // namespace

MergedField merge_shards(const std::vector<fs::path>& shards, const fs::path& output,
                         const std::function<bool()>& keep_going)
{
    const auto leave_if_cancelled = [&] {
        if (keep_going && !keep_going()) throw Cancelled();
    };
    const FileGuard guard;
    ShardSet set(shards, require_possible_identity);
    return set.is_surface() ? merge_surface(set, output, leave_if_cancelled)
                            : merge_chord(set, output, leave_if_cancelled);
}

}  // namespace lumi::baker
