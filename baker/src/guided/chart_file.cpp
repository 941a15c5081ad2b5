// SPDX-License-Identifier: MIT
#include "guided/chart_file.h"

#include "guided/guided_settings.h"

namespace lumi::baker
{
namespace
{

// No origin has these numbers.
constexpr uint32_t kSizesNumber = UINT32_MAX, kBaseNumber = UINT32_MAX - 1, kFirstPointsNumber = UINT32_MAX / 2;
static_assert(format::kMaxGuidedOrigins < kFirstPointsNumber);

std::vector<Block> blocks_of(const std::vector<uint32_t>& sizes, uint64_t& end)
{
    std::vector<Block> blocks;
    for (const uint32_t size : sizes) {
        blocks.push_back({end, static_cast<uint32_t>(blocks.size()), size});
        end = blocks.back().end();
    }
    return blocks;
}

std::vector<uint8_t> padded(std::vector<uint8_t> bytes, uint64_t size)
{
    bytes.resize(size);
    return bytes;
}

}  // namespace

ChartFile::ChartFile(BlockFile& file)
    : file_(file),
      settings_(checked(std::get<GuidedSettings>(file.identity().settings))),
      rows_(settings_.used_origins, file.identity().shard),
      slot_count_(0)
{
    check_shard(file.identity().shard);
    slot_count_ = settings_.texel == format::GuidedTexel::none ? 0 : rows_.size();
}

Block ChartFile::sizes_block() const
{
    return {kHeadBytes, kSizesNumber, 4 * (uint64_t{slot_count_} + 1)};
}

void ChartFile::set_sizes(Sizes sizes)
{
    sizes_ = std::move(sizes);
    end_ = sizes_block().end();
    base_ = {end_, kBaseNumber, sizes_.base};
    end_ = base_.end();
    charts_ = blocks_of(sizes_.charts, end_);
    for (uint32_t slot = 0; slot < charts_.size(); ++slot) {
        charts_[slot].number = origin_of(slot);
    }
    points_ = blocks_of(sizes_.points, end_);
    for (Block& block : points_) {
        block.number += kFirstPointsNumber;
    }
}

void ChartFile::write_sizes()
{
    ByteWriter out;
    out.put32(sizes_.base);
    for (const uint32_t size : sizes_.charts) {
        out.put32(size);
    }
    file_.write(sizes_block(), out.bytes());
}

bool ChartFile::read_sizes()
{
    std::vector<uint8_t> bytes;
    if (!file_.read(sizes_block(), bytes)) {
        return false;
    }
    ByteReader in(bytes.data(), bytes.size());
    Sizes sizes;
    sizes.base = in.get32();
    sizes.charts.resize(slot_count_);
    for (uint32_t& size : sizes.charts) {
        size = in.get32();
    }
    set_sizes(std::move(sizes));
    return true;
}

std::optional<TracedChart> ChartFile::read_chart(uint32_t slot) const
{
    std::vector<uint8_t> bytes;
    return file_.read(charts_[slot], bytes) ? decode_chart(bytes) : std::nullopt;
}

void ChartFile::write_chart(uint32_t slot, const TracedChart& chart)
{
    file_.write(charts_[slot], encode(chart));
}

std::optional<std::vector<ColourAtPoint>> ChartFile::read_points(uint32_t origin) const
{
    std::vector<uint8_t> bytes;
    return file_.read(points_[origin], bytes) ? decode_points(bytes) : std::nullopt;
}

void ChartFile::write_points(uint32_t origin, const std::vector<ColourAtPoint>& points)
{
    file_.write(points_[origin], padded(encode(points), points_[origin].size));
}

std::optional<std::vector<FieldSection>> ChartFile::read_base() const
{
    std::vector<uint8_t> bytes;
    return file_.read(base_, bytes) ? decode_sections(bytes) : std::nullopt;
}

void ChartFile::write_base(const std::vector<FieldSection>& base)
{
    file_.write(base_, encode(base));
}

std::vector<uint32_t> missing_slots(const ChartFile& charts)
{
    std::vector<uint32_t> missing;
    for (uint32_t slot = 0; slot < charts.slot_count(); ++slot) {
        if (!charts.read_chart(slot)) {
            missing.push_back(slot);
        }
    }
    return missing;
}

}  // namespace lumi::baker
