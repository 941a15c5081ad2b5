// SPDX-License-Identifier: MIT
#include "chord/chord_merge.h"

#include "chord/row_file.h"

namespace lumi::baker
{
namespace
{

bool same_colour(const detail::Rgba8& a, const detail::Rgba8& b)
{
    return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a;
}

// The rows of all shards.
class ChordShards
{
public:
    // Says what is wrong with them.
    ChordShards(ShardSet& set, const std::function<void()>& leave_if_cancelled) : set_(set)
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

}  // namespace

MergedField merge_chord(ShardSet& set, const std::filesystem::path& output,
                        const std::function<void()>& leave_if_cancelled)
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

}  // namespace lumi::baker
