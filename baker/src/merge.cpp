// SPDX-License-Identifier: MIT
#include "lumi/baker/merge.h"

#include "chord/field_writer.h"
#include "lumi/baker/file_guard.h"
#include "pack/shadow_patches.h"
#include "store/bake_identity.h"
#include "store/bake_stages.h"
#include "store/posix_file.h"
#include "store/shard_set.h"
#include "surface/surface_file_store.h"

namespace lumi::baker
{
namespace
{

namespace fs = std::filesystem;
using LeaveIfCancelled = std::function<void()>;

bool same_colour(const detail::Rgba8& a, const detail::Rgba8& b)
{
    return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a;
}

// The rows of all shards.
class ChordShards
{
public:
    // Says what is wrong with them.
    ChordShards(ShardSet& set, const LeaveIfCancelled& leave_if_cancelled) : set_(set)
    {
        for (const auto& [index, file] : set.shards()) {
            leave_if_cancelled();
            check(*shards_.emplace(index, *file).first);
        }
    }

    const FieldLayout& layout() const { return shards_.begin()->second.layout(); }
    const Palette& palette() const { return palette_; }

    void read(uint32_t i, std::vector<uint8_t>& row) const
    {
        const RowFile& rows = shards_.at(ShardRows::index_of(i, set_.count()));
        if (!rows.read_row(ShardRows::slot_of(i, set_.count()), row)) throw BakeError(changed_meanwhile(rows.path()));
    }

private:
    void check(const std::pair<const uint32_t, RowFile>& shard)
    {
        const RowFile& rows = shard.second;
        const std::vector<uint32_t> missing = missing_slots(rows);
        if (!missing.empty())
            set_.say_missing(rows.path(), missing.size(), rows.slot_count(), rows.row_of(missing.front()));
        Palette own{};
        if (!rows.read_palette(own)) {
            set_.say(rows.path(), "its palette is damaged; run its bake again");
        } else if (!has_palette_) {
            palette_ = own;
            has_palette_ = true;
        } else if (!std::equal(own.begin(), own.end(), palette_.begin(), same_colour)) {
            set_.say(rows.path(),
                     "has another palette than the first shard; bake it again on the machine of the others");
        }
    }

    ShardSet& set_;
    std::map<uint32_t, RowFile> shards_;  // by index
    Palette palette_{};
    bool has_palette_ = false;
};

MergedField merge_chord(ShardSet& set, const std::filesystem::path& output, const LeaveIfCancelled& leave_if_cancelled)
{
    const ChordShards shards(set, leave_if_cancelled);
    set.throw_problems();
    NewFile out(output);
    const auto read = [&](uint32_t i, std::vector<uint8_t>& row) {
        leave_if_cancelled();
        shards.read(i, row);
    };
    write_field(shards.layout(), read, shards.palette(), out);
    out.commit();
    MergedField field;
    field.bytes = file_bytes(shards.layout());
    field.origins = shards.layout().used_origins;
    field.directions = shards.layout().directions;
    field.shards = set.count();
    return field;
}

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

void add_shards(ShardSet& set, FitState& state, const LeaveIfCancelled& leave_if_cancelled)
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

MergedField merge_surface(ShardSet& set, const std::filesystem::path& output,
                          const LeaveIfCancelled& leave_if_cancelled)
{
    std::optional<FitBasis> basis = common_basis(set);
    set.throw_problems();
    const FitShape shape(std::move(basis->mesh), basis->densities, std::move(basis->see_through),
                         std::move(basis->gloss));
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
    FieldParts parts = solved({{state, nothing_kept}}, basis->sphere, job, ground_levels(basis->ground, shape.mesh));
    parts.is_draft = std::get<SurfaceSettings>(set.settings()).draft;
    FitShape with_shadows = shape;
    add_ground(basis->ground, with_shadows, parts);
    add_shadows(basis->shadows.shadows, with_shadows, parts);
    const std::vector<uint8_t> bytes = surface_file(with_shadows, parts);
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
