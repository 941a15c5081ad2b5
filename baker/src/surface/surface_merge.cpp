// SPDX-License-Identifier: MIT
#include "surface/surface_merge.h"

#include "store/bake_stages.h"
#include "store/new_file.h"
#include "surface/surface_file_store.h"

namespace lumi::baker
{
namespace
{

// The first basis; says of which shards it is missing or another one.
std::optional<FitBasis> common_basis(ShardSet& set)
{
    std::optional<FitBasis> first;
    for (const auto& [index, file] : set.shards()) {
        std::optional<FitBasis> basis = SurfaceFileStore(*file).read_basis();
        if (!basis)
            set.say(file->path(), "is not finished or damaged; run its bake again");
        else if (!first)
            first = std::move(basis);
        else if (encode(*basis) != encode(*first))
            set.say(file->path(), "has another mesh than the first shard; bake it again on the machine of the others");
    }
    return first;
}

void add_shards(ShardSet& set, FitState& state, const std::function<void()>& leave_if_cancelled)
{
    for (const auto& [index, file] : set.shards()) {
        leave_if_cancelled();
        SurfaceFileStore store(*file);
        std::vector<uint8_t> bytes;
        if (!store.read_basis() || !store.read_state(bytes) || !is_complete(bytes)) {
            set.say(file->path(), "is not finished or damaged; run its bake again");
        } else if (!add_encoded(bytes, state)) {
            set.say(file->path(),
                    "began from other light than the first shard; bake it again on the machine of the others");
        }
    }
}

}  // namespace

MergedField merge_surface(ShardSet& set, const std::filesystem::path& output,
                          const std::function<void()>& leave_if_cancelled)
{
    std::optional<FitBasis> basis = common_basis(set);
    set.throw_problems();
    const SurfaceSettings settings = std::get<SurfaceSettings>(set.shards().begin()->second->identity().settings);
    const FitShape shape(std::move(basis->mesh), basis->densities, std::move(basis->see_through));
    const EncodedTone tone(basis->tone);
    FitState state(shape, tone);
    add_shards(set, state, leave_if_cancelled);
    set.throw_problems();
    const ProgressCallback go_on = [&](const Progress&) {
        leave_if_cancelled();
        return true;
    };
    Job job(1, 0, go_on);
    BakeStages nothing_kept({}, {});
    const std::vector<uint8_t> bytes =
        surface_file(shape, solved(state, settings.view_tables, basis->sphere, nothing_kept, job));
    leave_if_cancelled();
    NewFile out(output);
    out.append(bytes);
    leave_if_cancelled();
    out.commit();
    MergedField field;
    field.bytes = bytes.size();
    field.shards = set.count();
    return field;
}

}  // namespace lumi::baker
