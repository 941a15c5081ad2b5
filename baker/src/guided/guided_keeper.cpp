// SPDX-License-Identifier: MIT
#include "guided/guided_keeper.h"

#include <numeric>

#include "chord/tracing_fingerprint.h"
#include "guided/guided_settings.h"

namespace lumi::baker
{

BakeIdentity identity_of(const Scene& scene, const GuidedSettings& settings, const Shard& shard)
{
    return identity_of(scene, checked(settings), shard, tracing_fingerprint(scene.data()));
}

std::vector<uint32_t> NothingKept::origins() const
{
    std::vector<uint32_t> all(origins_);
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

GuidedCheckpoint::GuidedCheckpoint(const std::filesystem::path& path, const BakeIdentity& identity, Earlier earlier)
    : checkpoint_(path, identity, earlier), charts_(checkpoint_.blocks())
{
}

std::vector<uint32_t> GuidedCheckpoint::origins() const
{
    std::vector<uint32_t> result(charts_.slot_count());
    for (uint32_t slot = 0; slot < result.size(); ++slot) {
        result[slot] = charts_.origin_of(slot);
    }
    return result;
}

void GuidedCheckpoint::begin(ChartFile::Sizes sizes)
{
    point_blocks_ = static_cast<uint32_t>(sizes.points.size());
    charts_.set_sizes(std::move(sizes));
    checkpoint_.reserve(charts_.complete_bytes(), is_empty());
    charts_.write_sizes();
}

bool GuidedCheckpoint::is_empty() const
{
    for (uint32_t i = 0; i < point_blocks_; ++i) {
        if (charts_.read_points(i)) {
            return false;
        }
    }
    return missing_slots(charts_).size() == charts_.slot_count();
}

std::optional<std::vector<ColourAtPoint>> GuidedCheckpoint::points(uint32_t origin) const
{
    return point_blocks_ == 0 ? std::nullopt : charts_.read_points(origin);
}

void GuidedCheckpoint::keep_base(const std::vector<FieldSection>& base)
{
    charts_.write_base(base);
}

void GuidedCheckpoint::keep_chart(uint32_t slot, const TracedChart& chart)
{
    charts_.write_chart(slot, chart);
    checkpoint_.sync_now_and_then();
}

void GuidedCheckpoint::keep_points(uint32_t origin, const std::vector<ColourAtPoint>& points)
{
    charts_.write_points(origin, points);
    checkpoint_.sync_now_and_then();
}

// Points go: whoever merges has no use for them.
void GuidedCheckpoint::rename_to(const std::filesystem::path& output)
{
    checkpoint_.blocks().file().cut(charts_.shard_bytes());
    checkpoint_.rename_to(output);
}

}  // namespace lumi::baker
