// SPDX-License-Identifier: MIT
// Where a guided bake keeps what it has traced.
#pragma once

#include "guided/chart_file.h"
#include "store/checkpoint.h"

namespace lumi::baker
{

// Of a guided bake. Throws BakeError for settings or shards that cannot be.
BakeIdentity identity_of(const Scene& scene, const GuidedSettings& settings, const Shard& shard);

// Charts are numbered by their slots, in the order of origins(). All but the constructor and begin() is thread-safe for
// different charts and points.
class GuidedKeeper
{
public:
    virtual ~GuidedKeeper() = default;

    // Of the charts to be traced.
    virtual std::vector<uint32_t> origins() const = 0;
    // Before anything is found or kept. Throws BakeError where there is no room.
    virtual void begin(ChartFile::Sizes sizes) = 0;

    // What an earlier bake kept.
    virtual std::optional<TracedChart> chart(uint32_t slot) const = 0;
    virtual std::optional<std::vector<ColourAtPoint>> points(uint32_t origin) const = 0;

    virtual void keep_base(const std::vector<FieldSection>& base) = 0;
    virtual void keep_chart(uint32_t slot, const TracedChart& chart) = 0;
    virtual void keep_points(uint32_t origin, const std::vector<ColourAtPoint>& points) = 0;
};

// All charts, kept nowhere.
class NothingKept : public GuidedKeeper
{
public:
    explicit NothingKept(uint32_t origins) : origins_(origins) {}

    std::vector<uint32_t> origins() const override;
    void begin(ChartFile::Sizes) override {}
    std::optional<TracedChart> chart(uint32_t) const override { return std::nullopt; }
    std::optional<std::vector<ColourAtPoint>> points(uint32_t) const override { return std::nullopt; }
    void keep_base(const std::vector<FieldSection>&) override {}
    void keep_chart(uint32_t, const TracedChart&) override {}
    void keep_points(uint32_t, const std::vector<ColourAtPoint>&) override {}

private:
    uint32_t origins_;
};

// A shard's charts, in a checkpoint.
class GuidedCheckpoint : public GuidedKeeper
{
public:
    // Opens the checkpoint at `path`, or begins one. Throws BakeError if it belongs to another bake or is in use.
    GuidedCheckpoint(const std::filesystem::path& path, const BakeIdentity& identity, Earlier earlier);

    std::vector<uint32_t> origins() const override;
    void begin(ChartFile::Sizes sizes) override;
    std::optional<TracedChart> chart(uint32_t slot) const override { return charts_.read_chart(slot); }
    std::optional<std::vector<ColourAtPoint>> points(uint32_t origin) const override;
    void keep_base(const std::vector<FieldSection>& base) override;
    void keep_chart(uint32_t slot, const TracedChart& chart) override;
    void keep_points(uint32_t origin, const std::vector<ColourAtPoint>& points) override;

    void sync() { checkpoint_.sync(); }
    void remove() { checkpoint_.remove(); }
    // The complete checkpoint becomes a shard.
    void rename_to(const std::filesystem::path& output);

private:
    bool is_empty() const;

    Checkpoint checkpoint_;
    ChartFile charts_;
    uint32_t point_blocks_ = 0;
};

}  // namespace lumi::baker
