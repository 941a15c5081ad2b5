// SPDX-License-Identifier: MIT
#include <numeric>

#include "chart_mask.h"
#include "chart_occlusion.h"
#include "chart_palettes.h"
#include "guided_settings.h"
#include "guided_tracer.h"
#include "guided_writer.h"
#include "lumi/baker/bake.h"
#include "lumi/baker/guided.h"
#include "mean_fit.h"
#include "new_file.h"
#include "proxy_cache.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kPointsPerNode = 12;  // colours that the mean is fitted to
// Light paths a point: few darken what is noisy, for colours are encoded before they are averaged.
constexpr uint32_t kMinPointPaths = 4, kMaxPointPaths = 16;
constexpr uint64_t kMaxPoints = 4'000'000;

// Before the number of rays is known: nothing is done, and no time has passed.
ProgressCallback preparing(const ProgressCallback& progress)
{
    return [&progress](const Progress&) { return !progress || progress({0, 1}); };
}

// One origin on its way.
struct Origin {
    ChartMask mask{0};
    ChartRows rows;
    std::vector<float> farthest;  // of each texel
};

class GuidedBaker
{
public:
    GuidedBaker(const Scene& scene, const GuidedSettings& settings, ProxyCache& cache)
        : scene_(scene.data()), s_(settings), cache_(cache.contents()), lattice_(s_.origins), origins_(s_.used_origins)
    {
        fill_head(scene);
    }

    GuidedBake bake(const ProgressCallback& progress) &&
    {
        prepare(1, preparing(progress));
        trace(progress);
        result_.file = guided_file(parts_);
        return std::move(result_);
    }

    // Of the file that bake() would make. Of every `stride` origins one is looked at and stands for all.
    uint64_t bytes(uint32_t stride, const ProgressCallback& progress) &&
    {
        prepare(stride, preparing(progress));
        fill_without_light();
        return guided_file(parts_).size();
    }

private:
    bool has_mean() const { return s_.mean_resolution != 0; }
    bool has_texels() const { return s_.texel != format::GuidedTexel::none; }

    ChartGeometry chart(uint32_t i) const { return {lattice_, i, s_.chart_size}; }

    void prepare(uint32_t stride, const ProgressCallback& progress)
    {
        Job job(1, s_.threads, progress);
        if (s_.surface == format::GuidedSurface::proxy) {
            fill_proxy(cache_.proxy(scene_, s_.proxy_triangles, job));
        }
        // The one in the middle of each stride: the lattice runs from pole to pole.
        const auto looked_at = [&](uint32_t i) { return std::min(s_.used_origins - 1, i - i % stride + stride / 2); };
        job.run((s_.used_origins + stride - 1) / stride, [&](uint32_t k) {
            const uint32_t i = looked_at(k * stride);
            const ChartGeometry geometry = chart(i);
            origins_[i].mask = proxy_ ? proxy_mask(geometry, *proxy_) : disc_mask(geometry);
            origins_[i].rows = origins_[i].mask.rows();
        });
        for (uint32_t i = 0; i < s_.used_origins; ++i) {
            if (i != looked_at(i)) {
                origins_[i] = origins_[looked_at(i)];
            }
        }
        for (const Origin& origin : origins_) {
            texels_ += origin.rows.texel_count;
        }
        if (has_mean()) {
            grid_.emplace(proxy_->mesh(), s_.mean_resolution);
            points_ = texels_ == 0 ? 0 : std::min(kMaxPoints, kPointsPerNode * grid_->size());
        }
    }

    void fill_proxy(const BuiltProxy& built)
    {
        result_.loss = built.loss;
        parts_.proxy = built.proxy;
        proxy_.emplace(unpacked(parts_.proxy), parts_.proxy.two_sided);
        result_.triangles = static_cast<uint32_t>(parts_.proxy.triangles.size());
        result_.vertices = static_cast<uint32_t>(parts_.proxy.vertices.size());
        result_.two_sided = parts_.proxy.two_sided;
    }

    // Parts of the right sizes, all black.
    void fill_without_light()
    {
        if (has_mean()) {
            colours_.resize(grid_->size());
            parts_.mean = packed_mean(*grid_, colours_, format::MeanFormat::rgb565);
            parts_.mean.format = s_.mean_format;
        }
        if (!has_texels()) {
            return;
        }
        const uint32_t entries = palette_entries(s_.texel);
        const uint32_t group = origins_per_palette(texels_, origins_.size(), entries);
        parts_.colours.resize((origins_.size() + group - 1) / group * entries * format::kChartColourBytes);
        for (const Origin& origin : origins_) {
            parts_.charts.push_back({origin.rows, std::vector<uint8_t>(origin.rows.texel_count)});
            if (s_.occlusion) {
                const ChartRows rows = origin.mask.blocks(format::kOcclusionShift).rows();
                parts_.occluded.push_back({rows, std::vector<uint8_t>(rows.texel_count)});
            }
        }
    }

    uint32_t paths_per_point() const { return std::clamp(s_.samples / 4, kMinPointPaths, kMaxPointPaths); }
    // Of the points up to the origin's first texel; the differences are the origins' shares.
    uint64_t points_before(uint64_t texel) const { return texels_ == 0 ? 0 : points_ * texel / texels_; }

    void trace(const ProgressCallback& progress)
    {
        const uint64_t texel_rays = has_texels() ? texels_ * s_.samples : 0;
        Job job(texel_rays + points_ * paths_per_point(), s_.threads, progress);
        const GuidedTracer tracer(scene_, proxy_ ? &*proxy_ : nullptr, s_.samples, s_.jitter, s_.seed);
        if (has_mean()) {
            trace_mean(tracer, job);
        }
        if (has_texels()) {
            trace_texels(tracer, job);
        }
        job.finish();
    }

    void trace_mean(const GuidedTracer& tracer, Job& job)
    {
        std::vector<std::vector<ColourAtPoint>> points(origins_.size());
        std::vector<uint64_t> first(origins_.size() + 1, 0);
        for (size_t i = 0; i < origins_.size(); ++i) {
            first[i + 1] = first[i] + origins_[i].rows.texel_count;
        }
        job.run(s_.used_origins, [&](uint32_t i) {
            const uint64_t count = points_before(first[i + 1]) - points_before(first[i]);
            points[i] = points_of(tracer, i, static_cast<uint32_t>(count), job);
        });
        MeanFit fit(*grid_);
        for (const std::vector<ColourAtPoint>& part : points) {
            for (const ColourAtPoint& point : part) {
                fit.add(point.x, point.colour);
            }
        }
        colours_ = fit.solve();
        parts_.mean = packed_mean(*grid_, colours_, s_.mean_format);
        result_.mean_bricks = static_cast<uint32_t>(parts_.mean.bricks.size() / format::kBrickNodes);
    }

    // Spread evenly over the origin's texels.
    std::vector<ColourAtPoint> points_of(const GuidedTracer& tracer, uint32_t i, uint32_t count, Job& job) const
    {
        std::vector<ColourAtPoint> result;
        const ChartGeometry geometry = chart(i);
        const Origin& origin = origins_[i];
        uint64_t done = 0;
        for (size_t r = 0; r < origin.rows.rows.size() && !job.stopping(); ++r) {
            const ChartRows::Row& row = origin.rows.rows[r];
            for (uint32_t k = 0; k < row.count; ++k) {
                const uint64_t end = uint64_t{count} * (row.at + k + 1) / origin.rows.texel_count;
                const Vec2 place = {static_cast<float>(row.first_u + k), static_cast<float>(origin.rows.first_v + r)};
                for (; done < end; ++done) {
                    if (const auto point =
                            tracer.point(geometry, i, static_cast<uint32_t>(done), place, paths_per_point())) {
                        result.push_back(*point);
                    }
                    job.add_rays(paths_per_point());
                }
            }
        }
        return result;
    }

    void trace_texels(const GuidedTracer& tracer, Job& job)
    {
        std::vector<ChartColours> charts(origins_.size());
        job.run(s_.used_origins, [&](uint32_t i) { charts[i] = trace_chart(tracer, i, job); });
        Palettes palettes = palettes_of(charts, s_.texel, has_mean(), job);
        parts_.origins_per_palette = palettes.origins_per_palette;
        parts_.colours = std::move(palettes.colours);
        for (size_t i = 0; i < origins_.size(); ++i) {
            parts_.charts.push_back({origins_[i].rows, std::move(palettes.texels[i])});
            if (s_.occlusion) {
                parts_.occluded.push_back(chart_occlusion(origins_[i].mask, origins_[i].rows, origins_[i].farthest));
            }
        }
        result_.texels = texels_;
    }

    ChartColours trace_chart(const GuidedTracer& tracer, uint32_t i, Job& job)
    {
        Origin& origin = origins_[i];
        const ChartGeometry geometry = chart(i);
        ChartColours result;
        result.levels.resize(origin.rows.texel_count);
        result.known.resize(origin.rows.texel_count);
        origin.farthest.resize(origin.rows.texel_count);
        const std::optional<MeanColour> mean = grid_ ? std::optional<MeanColour>({*grid_, colours_}) : std::nullopt;
        for (size_t r = 0; r < origin.rows.rows.size() && !job.stopping(); ++r) {
            const ChartRows::Row& row = origin.rows.rows[r];
            const uint32_t v = origin.rows.first_v + static_cast<uint32_t>(r);
            for (uint32_t k = 0; k < row.count; ++k) {
                const TexelEstimate texel = tracer.texel(geometry, i, row.first_u + k, v, mean ? &*mean : nullptr);
                result.levels[row.at + k] = texel.levels;
                result.known[row.at + k] = texel.known ? 1 : 0;
                origin.farthest[row.at + k] = texel.farthest;
            }
            job.add_rays(uint64_t{row.count} * s_.samples);
        }
        return result;
    }

    void fill_head(const Scene& scene)
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

    const SceneData& scene_;
    const GuidedSettings s_;
    ProxyCache::Contents& cache_;
    const Lattice lattice_;
    std::optional<ProxyTracer> proxy_;
    std::vector<Origin> origins_;
    uint64_t texels_ = 0, points_ = 0;
    std::optional<NodeGrid> grid_;
    std::vector<Levels> colours_;
    GuidedParts parts_;
    GuidedBake result_;
};

}  // namespace

ProxyCache::ProxyCache() : contents_(std::make_unique<Contents>()) {}

ProxyCache::~ProxyCache() = default;

GuidedBake guided_field(const Scene& scene, const GuidedSettings& settings, const ProgressCallback& progress,
                        ProxyCache* cache)
{
    ProxyCache own;
    return GuidedBaker(scene, checked(settings), cache == nullptr ? own : *cache).bake(progress);
}

uint64_t guided_file_bytes(const Scene& scene, const GuidedSettings& settings, ProxyCache& cache,
                           uint32_t sampled_origins, const ProgressCallback& progress)
{
    const GuidedSettings s = checked(settings);
    const uint32_t stride = sampled_origins == 0 ? 1 : std::max(1u, s.used_origins / sampled_origins);
    return GuidedBaker(scene, s, cache).bytes(stride, progress);
}

GuidedBake bake_guided(const Scene& scene, const GuidedSettings& settings, const std::filesystem::path& output,
                       const ProgressCallback& progress)
{
    GuidedBake bake = guided_field(scene, settings, progress);
    NewFile file(output);
    file.append(bake.file);
    file.commit();
    return bake;
}

}  // namespace lumi::baker
