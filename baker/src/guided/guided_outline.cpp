// SPDX-License-Identifier: MIT
#include "guided/guided_outline.h"

#include "guided/chart_blocks.h"
#include "guided/guided_settings.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kPointsPerNode = 12;  // colours that the mean is fitted to
constexpr uint64_t kMaxPoints = 4'000'000;

// Before the number of rays is known: nothing is done, and no time has passed.
ProgressCallback preparing(const ProgressCallback& progress)
{
    return [&progress](const Progress&) { return !progress || progress({0, 1}); };
}

}  // namespace

GuidedOutline::GuidedOutline(const Scene& scene, const GuidedSettings& settings, ProxyCache::Contents& cache)
    : scene_(scene.data()), s_(settings), cache_(cache), lattice_(s_.origins), origins_(s_.used_origins)
{
    fill_head(scene);
}

void GuidedOutline::fill_head(const Scene& scene)
{
    parts_.origins = s_.origins;
    parts_.used_origins = s_.used_origins;
    parts_.chart_size = s_.chart_size;
    parts_.texel = s_.texel;
    parts_.surface = s_.surface;
    parts_.centre = scene.centre();
    parts_.radius = scene.radius();
    if (s_.surface == format::GuidedSurface::focus) {
        const PackedFocus focus = focus_of(scene_, s_);
        parts_.focus_q14 = focus.point_q14;
        parts_.focus_radius_q14 = focus.radius_q14;
    }
}

void GuidedOutline::fill_proxy(const BuiltProxy& built)
{
    loss_ = built.loss;
    parts_.proxy = built.proxy;
    proxy_.emplace(unpacked(parts_.proxy), parts_.proxy.two_sided);
}

GuidedOutline::Origin GuidedOutline::look(uint32_t origin) const
{
    Origin result;
    result.mask = proxy_ ? proxy_mask(chart(origin), *proxy_) : disc_mask(chart(origin));
    result.rows = result.mask.rows();
    return result;
}

void GuidedOutline::prepare(uint32_t stride, const ProgressCallback& progress)
{
    const ProgressCallback nothing_done = preparing(progress);
    Job job(1, s_.threads, nothing_done);
    if (s_.surface == format::GuidedSurface::proxy) {
        fill_proxy(cache_.proxy(scene_, s_.proxy_triangles, job));
    }
    // The one in the middle of each stride: the lattice runs from pole to pole.
    const auto looked_at = [&](uint32_t i) { return std::min(s_.used_origins - 1, i - i % stride + stride / 2); };
    job.run((s_.used_origins + stride - 1) / stride, [&](uint32_t k) {
        const uint32_t i = looked_at(k * stride);
        origins_[i] = look(i);
    });
    for (uint32_t i = 0; i < s_.used_origins; ++i) {
        if (i != looked_at(i)) {
            origins_[i] = origins_[looked_at(i)];
        }
        texels_before_.push_back(texels() + rows(i).texel_count);
    }
    if (has_texels()) {
        parts_.origins_per_palette = origins_per_palette(texels(), origins_.size(), s_.texel);
    }
    if (has_mean()) {
        grid_.emplace(proxy_->mesh(), s_.mean_resolution);
        points_ = texels() == 0 ? 0 : std::min(kMaxPoints, kPointsPerNode * grid_->size());
    }
}

// Each origin's share of them is that of its texels.
uint32_t GuidedOutline::points(uint32_t origin) const
{
    return static_cast<uint32_t>(points_before(texels_before_[origin + 1]) - points_before(texels_before_[origin]));
}

ChartRows GuidedOutline::occluded_rows(uint32_t origin) const
{
    return s_.occlusion ? mask(origin).blocks(format::kOcclusionShift).rows() : ChartRows();
}

GuidedParts GuidedOutline::base_without_light() const
{
    GuidedParts parts = parts_;
    if (has_mean()) {
        std::vector<Levels> black(grid_->size());
        parts.mean = packed_mean(*grid_, black, format::MeanFormat::rgb565);
        parts.mean.format = s_.mean_format;
    }
    return parts;
}

ChartFile::Sizes GuidedOutline::sizes(const std::vector<uint32_t>& origins) const
{
    ChartFile::Sizes sizes;
    sizes.base = static_cast<uint32_t>(encode(base_sections(base_without_light())).size());
    for (const uint32_t i : origins) {
        sizes.charts.push_back(static_cast<uint32_t>(chart_bytes(rows(i), occluded_rows(i))));
    }
    for (uint32_t i = 0; has_mean() && i < s_.used_origins; ++i) {
        sizes.points.push_back(static_cast<uint32_t>(points_bytes(points(i))));
    }
    return sizes;
}

uint64_t GuidedOutline::bytes() const
{
    GuidedParts parts = base_without_light();
    if (has_texels()) {
        const uint32_t group = parts.origins_per_palette, palettes = (s_.used_origins + group - 1) / group;
        parts.colours.resize(size_t{palettes} * format::chart_colours(s_.texel) * format::kChartColourBytes);
        for (uint32_t i = 0; i < s_.used_origins; ++i) {
            const ChartRows stored = s_.texel == format::GuidedTexel::vq8 ? block_rows(rows(i)) : rows(i);
            parts.charts.push_back({stored, std::vector<uint8_t>(stored.texel_count)});
            if (s_.occlusion) {
                const ChartRows occluded = occluded_rows(i);
                parts.occluded.push_back({occluded, std::vector<uint8_t>(occluded.texel_count)});
            }
        }
    }
    return guided_file(parts).size();
}

}  // namespace lumi::baker
