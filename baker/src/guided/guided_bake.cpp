// SPDX-License-Identifier: MIT
#include "guided/chart_occlusion.h"
#include "guided/guided_assembly.h"
#include "guided/guided_keeper.h"
#include "guided/guided_outline.h"
#include "guided/guided_settings.h"
#include "guided/mean_fit.h"
#include "lumi/baker/bake.h"
#include "lumi/baker/guided.h"
#include "store/new_file.h"
#include "store/output_names.h"
#include "trace/catcher.h"

namespace lumi::baker
{
namespace
{

// Light paths a point: few darken what is noisy, for colours are encoded before they are averaged.
constexpr uint32_t kMinPointPaths = 4, kMaxPointPaths = 16;

// Traces what a keeper does not have yet.
class GuidedBaker
{
public:
    GuidedBaker(const Scene& scene, const GuidedSettings& settings, ProxyCache& cache, GuidedKeeper& keeper,
                const ProgressCallback& progress)
        : s_(settings),
          keeper_(keeper),
          progress_(progress),
          origins_(keeper.origins()),
          outline_(scene, s_, cache.contents()),
          scene_(scene.data())
    {
    }

    void trace()
    {
        outline_.prepare(1, progress_);
        static_cast<void>(outline_.bytes());  // throws before the work if no file can hold the field
        keeper_.begin(outline_.sizes(origins_));
        find_earlier();
        tracer_.emplace(scene_, outline_.proxy(), s_.samples, s_.jitter, s_.seed);
        job_.emplace(rays_of(all_), s_.threads, progress_, rays_of(found_));
        GuidedParts parts = outline_.parts();
        if (outline_.has_mean()) {
            parts.mean = trace_mean();
        }
        result_.mean_bricks = static_cast<uint32_t>(parts.mean.bricks.size() / format::kBrickNodes);
        base_ = base_sections(parts);
        keeper_.keep_base(base_);
        if (outline_.has_texels()) {
            trace_charts();
        }
    }

    // After all charts are traced.
    GuidedBake field()
    {
        result_.file = assembled_field(std::move(base_), std::move(charts_), s_, *job_);
        job_->finish();
        result_.loss = outline_.loss();
        const PackedProxy& proxy = outline_.parts().proxy;
        result_.triangles = static_cast<uint32_t>(proxy.triangles.size());
        result_.vertices = static_cast<uint32_t>(proxy.vertices.size());
        result_.two_sided = proxy.two_sided;
        result_.texels = outline_.has_texels() ? outline_.texels() : 0;
        return std::move(result_);
    }

    // In place of a field.
    void finish_shard() { job_->finish(); }

private:
    struct Amount {
        uint64_t texels = 0, points = 0;
    };

    uint32_t paths_per_point() const { return std::clamp(s_.samples / 4, kMinPointPaths, kMaxPointPaths); }

    uint64_t rays_of(const Amount& amount) const
    {
        return amount.texels * s_.samples + amount.points * paths_per_point();
    }

    void find_earlier()
    {
        charts_.resize(origins_.size());
        for (uint32_t slot = 0; slot < origins_.size() && outline_.has_texels(); ++slot) {
            const uint64_t texels = outline_.rows(origins_[slot]).texel_count;
            all_.texels += texels;
            if (std::optional<TracedChart> chart = keeper_.chart(slot)) {
                charts_[slot] = std::move(*chart);
                found_.texels += texels;
            } else {
                missing_.push_back(slot);
            }
        }
        points_.resize(s_.used_origins);
        for (uint32_t i = 0; i < s_.used_origins && outline_.has_mean(); ++i) {
            all_.points += outline_.points(i);
            points_[i] = keeper_.points(i);
            found_.points += points_[i] ? outline_.points(i) : 0;
        }
    }

    PackedMean trace_mean()
    {
        job_->run(s_.used_origins, [this](uint32_t i) {
            if (!points_[i]) {
                points_[i] = points_of(i);
                if (!job_->stopping()) {
                    keeper_.keep_points(i, *points_[i]);
                }
            }
        });
        MeanFit fit(*outline_.grid());
        for (std::optional<std::vector<ColourAtPoint>>& part : points_) {
            for (const ColourAtPoint& point : *part) {
                fit.add(point.x, point.colour);
            }
            part.reset();
        }
        colours_ = fit.solve();
        return packed_mean(*outline_.grid(), colours_, s_.mean_format);
    }

    // Spread evenly over the origin's texels.
    std::vector<ColourAtPoint> points_of(uint32_t i)
    {
        std::vector<ColourAtPoint> result;
        const ChartGeometry geometry = outline_.chart(i);
        const ChartRows& rows = outline_.rows(i);
        const uint64_t count = outline_.points(i);
        uint64_t done = 0;
        for (size_t r = 0; r < rows.rows.size() && !job_->stopping(); ++r) {
            const ChartRows::Row& row = rows.rows[r];
            for (uint32_t k = 0; k < row.count; ++k) {
                const uint64_t end = count * (row.at + k + 1) / rows.texel_count;
                const Vec2 place = {static_cast<float>(row.first_u + k), static_cast<float>(rows.first_v + r)};
                for (; done < end; ++done) {
                    if (const auto point =
                            tracer_->point(geometry, i, static_cast<uint32_t>(done), place, paths_per_point())) {
                        result.push_back(*point);
                    }
                    job_->add_rays(paths_per_point());
                }
            }
        }
        return result;
    }

    void trace_charts()
    {
        job_->run(static_cast<uint32_t>(missing_.size()), [this](uint32_t k) {
            const uint32_t slot = missing_[k];
            charts_[slot] = trace_chart(origins_[slot]);
            if (!job_->stopping()) {
                keeper_.keep_chart(slot, charts_[slot]);
            }
        });
    }

    TracedChart trace_chart(uint32_t i)
    {
        const ChartGeometry geometry = outline_.chart(i);
        TracedChart result = {outline_.rows(i), {}, {}};
        const ChartRows& rows = result.rows;
        result.colours.levels.resize(rows.texel_count);
        result.colours.known.resize(rows.texel_count);
        std::vector<float> farthest(rows.texel_count);
        const NodeGrid* grid = outline_.grid();
        const std::optional<MeanColour> mean = grid ? std::optional<MeanColour>({*grid, colours_}) : std::nullopt;
        for (size_t r = 0; r < rows.rows.size() && !job_->stopping(); ++r) {
            const ChartRows::Row& row = rows.rows[r];
            const uint32_t v = rows.first_v + static_cast<uint32_t>(r);
            for (uint32_t k = 0; k < row.count; ++k) {
                const TexelEstimate texel = tracer_->texel(geometry, i, row.first_u + k, v, mean ? &*mean : nullptr);
                result.colours.levels[row.at + k] = texel.levels;
                result.colours.known[row.at + k] = texel.known ? 1 : 0;
                farthest[row.at + k] = texel.farthest;
            }
            job_->add_rays(uint64_t{row.count} * s_.samples);
        }
        if (s_.occlusion) {
            result.occluded = chart_occlusion(outline_.mask(i), rows, farthest);
        }
        return result;
    }

    const GuidedSettings s_;
    GuidedKeeper& keeper_;
    const ProgressCallback& progress_;
    const std::vector<uint32_t> origins_;  // by slot
    GuidedOutline outline_;
    const SceneData& scene_;
    std::optional<GuidedTracer> tracer_;
    std::optional<Job> job_;
    Amount all_, found_;
    std::vector<std::optional<std::vector<ColourAtPoint>>> points_;  // by origin
    std::vector<TracedChart> charts_;                                // by slot
    std::vector<uint32_t> missing_;                                  // slots
    std::vector<Levels> colours_;                                    // of the mean
    std::vector<FieldSection> base_;
    GuidedBake result_;
};

bool has_all(BlockFile& file)
{
    ChartFile charts(file);
    return charts.read_sizes() && charts.read_base() && missing_slots(charts).empty();
}

}  // namespace

GuidedBake guided_field(const Scene& scene, const GuidedSettings& settings, const ProgressCallback& progress,
                        ProxyCache* cache)
{
    ProxyCache own;
    require_partial_coverage(scene.data(), false);
    const GuidedSettings s = checked(settings);
    NothingKept keeper(s.used_origins);
    GuidedBaker baker(scene, s, cache == nullptr ? own : *cache, keeper, progress);
    baker.trace();
    return baker.field();
}

uint64_t guided_file_bytes(const Scene& scene, const GuidedSettings& settings, ProxyCache& cache,
                           uint32_t sampled_origins, const ProgressCallback& progress)
{
    require_partial_coverage(scene.data(), false);
    const GuidedSettings s = checked(settings);
    const uint32_t stride = sampled_origins == 0 ? 1 : std::max(1u, s.used_origins / sampled_origins);
    GuidedOutline outline(scene, s, cache.contents());
    outline.prepare(stride, progress);
    return outline.bytes();
}

GuidedBake bake_guided(const Scene& scene, const GuidedSettings& settings, const std::filesystem::path& output,
                       const ProgressCallback& progress, Earlier earlier)
{
    require_partial_coverage(scene.data(), false);
    const GuidedSettings s = checked(settings);
    GuidedCheckpoint checkpoint(checkpoint_of(output), identity_of(scene, s, {}), earlier);
    ProxyCache cache;
    GuidedBaker baker(scene, s, cache, checkpoint, progress);
    baker.trace();
    checkpoint.sync();
    GuidedBake bake = baker.field();
    NewFile file(output);
    file.append(bake.file);
    file.commit();
    checkpoint.remove();
    return bake;
}

void bake_guided_shard(const Scene& scene, const GuidedSettings& settings, const Shard& shard,
                       const std::filesystem::path& output, const ProgressCallback& progress, Earlier earlier)
{
    require_partial_coverage(scene.data(), false);
    const GuidedSettings s = checked(settings);
    const BakeIdentity identity = identity_of(scene, s, shard);
    if (earlier == Earlier::resume && is_finished_shard(output, identity, has_all)) {
        return;
    }
    GuidedCheckpoint checkpoint(checkpoint_of(output), identity, earlier);
    ProxyCache cache;
    GuidedBaker baker(scene, s, cache, checkpoint, progress);
    baker.trace();
    baker.finish_shard();
    checkpoint.rename_to(output);
}

}  // namespace lumi::baker
