// SPDX-License-Identifier: MIT
// What of a guided field follows from scene and settings without a light path: its surface, its rows, its size.
#pragma once

#include <optional>

#include "guided/chart_file.h"
#include "guided/chart_mask.h"
#include "lumi/lattice.h"
#include "proxy/proxy_cache.h"

namespace lumi::baker
{

class GuidedOutline
{
public:
    // Borrows all; `settings` as checked() returns them. Throws BakeError.
    GuidedOutline(const Scene& scene, const GuidedSettings& settings, ProxyCache::Contents& cache);

    // To be called once, before the rest. Of every `stride` origins one is looked at and stands for all. Progress only
    // says that nothing is done yet. Throws Cancelled.
    void prepare(uint32_t stride, const ProgressCallback& progress);

    bool has_mean() const { return s_.mean_resolution != 0; }
    bool has_texels() const { return s_.texel != format::GuidedTexel::none; }

    // Head, proxy and what the settings say; neither light nor charts.
    const GuidedParts& parts() const { return parts_; }
    const ProxyLoss& loss() const { return loss_; }
    const ProxyTracer* proxy() const { return proxy_ ? &*proxy_ : nullptr; }  // null: a focus surface
    const NodeGrid* grid() const { return grid_ ? &*grid_ : nullptr; }        // null: no mean
    ChartGeometry chart(uint32_t origin) const { return {lattice_, origin, s_.chart_size}; }
    const ChartMask& mask(uint32_t origin) const { return origins_[origin].mask; }
    const ChartRows& rows(uint32_t origin) const { return origins_[origin].rows; }
    uint64_t texels() const { return texels_before_.back(); }
    // Points that the mean is fitted to: those seen from one origin, and from all.
    uint32_t points(uint32_t origin) const;
    uint64_t points() const { return points_; }

    // Of the blocks for these charts.
    ChartFile::Sizes sizes(const std::vector<uint32_t>& origins) const;
    // Of the field's file.
    uint64_t bytes() const;

private:
    struct Origin {
        ChartMask mask{0};
        ChartRows rows;
    };

    void fill_head(const Scene& scene);
    void fill_proxy(const BuiltProxy& built);
    Origin look(uint32_t origin) const;
    ChartRows occluded_rows(uint32_t origin) const;
    // Of the right sizes, all black.
    GuidedParts base_without_light() const;
    uint64_t points_before(uint64_t texel) const { return texels() == 0 ? 0 : points_ * texel / texels(); }

    const SceneData& scene_;
    const GuidedSettings& s_;
    ProxyCache::Contents& cache_;
    const Lattice lattice_;
    GuidedParts parts_;
    ProxyLoss loss_;
    std::optional<ProxyTracer> proxy_;
    std::vector<Origin> origins_;
    std::vector<uint64_t> texels_before_ = {0};  // each origin, and the end
    uint64_t points_ = 0;
    std::optional<NodeGrid> grid_;
};

}  // namespace lumi::baker
