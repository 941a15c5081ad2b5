// SPDX-License-Identifier: MIT
#include "surface/surface_fit.h"

#include "surface/texel_fill.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kPilotSeedOffset = 0x70696C6F, kShareSeedOffset = 0x73686172;
constexpr uint32_t kShareBatches = 16;
constexpr double kPilotPaths = 65;        // a texel; more gain nothing
constexpr double kMaxPilotPaths = 1.6e7;  // of all texels together: they are kept in memory
constexpr int kPilotRounds = 4;           // each linear around the one before
constexpr int kPilotIterations = 12, kIterations = 60;
constexpr uint32_t kBatchesAtOnce = 512;
constexpr uint32_t kPatchesATask = 16;

// Calls f(patch) for all patches.
template <class Function>
void for_patches(uint32_t patches, Job& job, Function f)
{
    job.run((patches + kPatchesATask - 1) / kPatchesATask, [&](uint32_t task) {
        const uint32_t end = std::min(patches, (task + 1) * kPatchesATask);
        for (uint32_t p = task * kPatchesATask; p < end; ++p) {
            f(p);
        }
    });
}

SurfaceModel empty_model(const SurfaceShape& shape)
{
    return {std::vector<LevelColour>(shape.layout.texels),
            std::vector<LevelColour>(shape.mesh.positions.size() * format::kViewNodes)};
}

// The levels of each texel's mean light; of those with few paths nearly their patch's.
void start_from_means(const SurfaceShape& shape, const SortedSamples& samples, const EncodedTone& tone,
                      SurfaceModel& model)
{
    constexpr float kPatchPaths = 4;
    for (uint32_t p = 0; p < shape.mesh.patches.size(); ++p) {
        const PatchRectangle& r = shape.layout.rectangles[p];
        std::vector<Rgb> sums(r.size());
        std::vector<float> counts(r.size());
        Rgb all;
        for (const SurfaceSample* s = samples.begin(p); s != samples.end(p); ++s) {
            sums[s->texel - r.begin] = sums[s->texel - r.begin] + s->radiance;
            counts[s->texel - r.begin] += 1;
            all = all + s->radiance;
        }
        const auto paths = static_cast<float>(samples.end(p) - samples.begin(p));
        const Rgb mean = all * (1 / std::max(paths, 1.0f));
        for (size_t t = 0; t < sums.size(); ++t) {
            model.texels[r.begin + t] = tone.encoded((sums[t] + mean * kPatchPaths) * (1 / (counts[t] + kPatchPaths)));
        }
    }
}

}  // namespace

SurfaceFit::SurfaceFit(const SceneData& scene, const SurfaceShape& shape, const SurfaceSettings& settings)
    : shape_(shape), settings_(settings), tone_(scene.tone), tracer_(scene, shape), smoothness_(shape)
{
    uint32_t lines = 0;
    for (uint32_t k = 0; k < kShareBatches; ++k) {
        lines += tracer_.meeting(settings.seed + kShareSeedOffset, k).scene;
    }
    paths_per_batch_ = std::max(1.0, lines / static_cast<double>(kShareBatches));
}

uint32_t SurfaceFit::batches_for(double paths) const
{
    return static_cast<uint32_t>(std::ceil(paths / paths_per_batch_));
}

SortedSamples SurfaceFit::traced(uint64_t seed, uint32_t first, uint32_t count, Job& job) const
{
    std::vector<std::vector<SurfaceSample>> batches(count);
    job.run(count, [&](uint32_t k) {
        batches[k] = tracer_.samples(seed, first + k);
        job.add_rays(SurfaceTracer::kLines);
    });
    return sorted(batches, static_cast<uint32_t>(shape_.mesh.patches.size()));
}

void SurfaceFit::pilot(Job& job)
{
    const auto patches = static_cast<uint32_t>(shape_.mesh.patches.size());
    const double paths = std::min(kPilotPaths * shape_.layout.texels, kMaxPilotPaths);
    const SortedSamples samples = traced(settings_.seed + kPilotSeedOffset, 0, batches_for(paths), job);
    expected_ = empty_model(shape_);
    start_from_means(shape_, samples, tone_, expected_);
    for (int round = 0; round < kPilotRounds; ++round) {
        SurfaceSums sums(shape_, tone_, expected_, White::goes_on);
        for_patches(patches, job, [&](uint32_t p) { sums.add(p, samples.begin(p), samples.end(p)); });
        SurfaceModel next = expected_;
        const std::vector<uint8_t> all;
        SurfaceSolver(sums, smoothness_, all, job).solve(next, kPilotIterations);
        expected_ = std::move(next);
    }
}

void SurfaceFit::trace(const ProgressCallback& progress)
{
    const auto patches = static_cast<uint32_t>(shape_.mesh.patches.size());
    const uint32_t batches = batches_for(static_cast<double>(settings_.paths_per_texel) * shape_.layout.texels);
    const uint32_t first = batches_for(std::min(kPilotPaths * shape_.layout.texels, kMaxPilotPaths));
    Job job(uint64_t{SurfaceTracer::kLines} * (first + batches), settings_.threads, progress);
    pilot(job);
    sums_.emplace(shape_, tone_, expected_, White::clips);
    for (uint32_t k = 0; k < batches; k += kBatchesAtOnce) {
        const SortedSamples samples = traced(settings_.seed, k, std::min(kBatchesAtOnce, batches - k), job);
        for_patches(patches, job, [&](uint32_t p) { sums_->add(p, samples.begin(p), samples.end(p)); });
        paths_ += samples.samples.size();
    }
    for (PatchSums& patch : sums_->patches()) {
        patch.pairs.sort();
    }
    job.finish();
}

SurfaceModel SurfaceFit::solve(const std::vector<uint8_t>& viewed, Job& job) const
{
    SurfaceModel model = expected_;
    SurfaceSolver(*sums_, smoothness_, viewed, job).solve(model, kIterations);
    finish_texels(model);
    return model;
}

void SurfaceFit::refit_texels(SurfaceModel& model, Job& job) const
{
    const std::vector<uint8_t> all;
    SurfaceSolver(*sums_, smoothness_, all, job).fit_texels(model);
    finish_texels(model);
}

// Takes the line back: the mean light that it stands for, encoded.
void SurfaceFit::finish_texels(SurfaceModel& model) const
{
    for (uint32_t p = 0; p < shape_.mesh.patches.size(); ++p) {
        const PatchRectangle& r = shape_.layout.rectangles[p];
        std::vector<uint32_t> counts;
        for (size_t t = 0; t < r.size(); ++t) {
            const TexelSums& texel = sums_->patches()[p].texels[t];
            counts.push_back(texel.count);
            const double unit = kLevelUnit / std::max(texel.count, 1u);
            LevelColour expected, target;
            for (size_t c = 0; c < 3; ++c) {
                expected[c] = std::min(255.0f, static_cast<float>(unit * static_cast<double>(texel.predicted[c])));
                target[c] = static_cast<float>(unit * static_cast<double>(texel.target[c]));
            }
            const LevelColour shown = tone_.encoded(tone_.line_at(expected).inverse(target));
            for (size_t c = 0; c < 3 && texel.count != 0; ++c) {
                model.texels[r.begin + t][c] += shown[c] - target[c];
            }
        }
        smooth_starved(&model.texels[r.begin], counts, r.n);
    }
}

}  // namespace lumi::baker
