// SPDX-License-Identifier: MIT
// The blocks of a guided bake: traced charts, and the colours at points that the mean is fitted to.
//
//   sizes    of the blocks "base" and "charts", so that a shard can be read without its scene
//   base     the field's sections apart from the charts', the same in all shards
//   charts   what of a chart goes into the field, before palettes; one for each origin of the shard, in order
//   points   colours at points, for every origin: texels are differences from a mean that all origins have in common.
//            A complete shard has none of them any more.
#pragma once

#include <optional>

#include "guided/guided_writer.h"
#include "guided/traced_chart.h"
#include "store/block_file.h"
#include "store/shard_rows.h"

namespace lumi::baker
{

class ChartFile
{
public:
    // Without seals. Charts: of the shard's origins; points: of all origins, nothing where there is no mean.
    struct Sizes {
        uint32_t base = 0;
        std::vector<uint32_t> charts, points;
    };

    // Borrows `file`, which must be of a guided bake. Throws BakeError for settings or shards that cannot be.
    explicit ChartFile(BlockFile& file);

    const std::filesystem::path& path() const { return file_.path(); }
    const GuidedSettings& settings() const { return settings_; }
    uint32_t slot_count() const { return slot_count_; }
    uint32_t origin_of(uint32_t slot) const { return rows_.row(slot); }

    // Before anything is read or written, the file's sizes must be known: by calculation, or by what the file says.
    void set_sizes(Sizes sizes);
    void write_sizes();
    bool read_sizes();  // of a complete shard; false if they are not there
    uint64_t complete_bytes() const { return end_; }
    uint64_t shard_bytes() const { return charts_.empty() ? base_.end() : charts_.back().end(); }

    // Empty if it is not there. All are thread-safe for different blocks.
    std::optional<TracedChart> read_chart(uint32_t slot) const;
    void write_chart(uint32_t slot, const TracedChart& chart);
    std::optional<std::vector<ColourAtPoint>> read_points(uint32_t origin) const;
    void write_points(uint32_t origin, const std::vector<ColourAtPoint>& points);
    std::optional<std::vector<FieldSection>> read_base() const;
    void write_base(const std::vector<FieldSection>& base);

private:
    Block sizes_block() const;

    BlockFile& file_;
    GuidedSettings settings_;
    ShardRows rows_;
    uint32_t slot_count_;
    Sizes sizes_;
    Block base_{};
    std::vector<Block> charts_, points_;
    uint64_t end_ = 0;
};

// Slots whose charts are not there; reads all of them.
std::vector<uint32_t> missing_slots(const ChartFile& charts);

}  // namespace lumi::baker
