// SPDX-License-Identifier: MIT
#include "guided/guided_merge.h"

#include "guided/chart_file.h"
#include "guided/guided_assembly.h"
#include "store/new_file.h"

namespace lumi::baker
{
namespace
{

bool same_section(const FieldSection& a, const FieldSection& b)
{
    return a.type == b.type && a.bytes == b.bytes;
}

// The charts of all shards, as they are read.
class GuidedShards
{
public:
    // Says what is wrong with them.
    GuidedShards(ShardSet& set, const std::function<void()>& leave_if_cancelled) : set_(set)
    {
        for (const auto& [index, file] : set.shards()) {
            leave_if_cancelled();
            read(*file);
        }
    }

    const GuidedSettings& settings() const { return settings_; }
    std::vector<FieldSection> take_base() { return std::move(base_); }
    std::vector<TracedChart> take_charts() { return std::move(charts_); }

private:
    void read(BlockFile& file)
    {
        ChartFile shard(file);
        settings_ = shard.settings();
        charts_.resize(settings_.used_origins);
        if (!shard.read_sizes()) {
            set_.say(shard.path(), "is not finished or damaged; run its bake again");
            return;
        }
        check_base(shard);
        size_t missing = 0;
        uint32_t first = 0;
        for (uint32_t slot = shard.slot_count(); slot-- > 0;) {
            const uint32_t origin = shard.origin_of(slot);
            if (std::optional<TracedChart> chart = shard.read_chart(slot)) {
                charts_[origin] = std::move(*chart);
            } else {
                ++missing;
                first = origin;
            }
        }
        if (missing != 0) {
            set_.say_missing(shard.path(), missing, shard.slot_count(), first);
        }
    }

    void check_base(const ChartFile& shard)
    {
        std::optional<std::vector<FieldSection>> base = shard.read_base();
        if (!base) {
            set_.say(shard.path(), "its surface or its mean colours are damaged; run its bake again");
        } else if (base_.empty()) {
            base_ = std::move(*base);
        } else if (!std::equal(base_.begin(), base_.end(), base->begin(), base->end(), same_section)) {
            set_.say(shard.path(),
                     "has another surface or other mean colours than the first shard; bake it again on the machine of "
                     "the others");
        }
    }

    ShardSet& set_;
    GuidedSettings settings_;
    std::vector<FieldSection> base_;
    std::vector<TracedChart> charts_;
};

}  // namespace

MergedField merge_guided(ShardSet& set, const std::filesystem::path& output,
                         const std::function<void()>& leave_if_cancelled)
{
    GuidedShards shards(set, leave_if_cancelled);
    set.throw_problems();
    const ProgressCallback go_on = [&](const Progress&) {
        leave_if_cancelled();
        return true;
    };
    Job job(1, 0, go_on);
    const std::vector<uint8_t> bytes =
        assembled_field(shards.take_base(), shards.take_charts(), shards.settings(), job);
    leave_if_cancelled();
    NewFile out(output);
    out.append(bytes);
    leave_if_cancelled();
    out.commit();
    MergedField field;
    field.bytes = bytes.size();
    field.origins = shards.settings().used_origins;
    field.chart_size = shards.settings().chart_size;
    field.shards = set.count();
    return field;
}

}  // namespace lumi::baker
