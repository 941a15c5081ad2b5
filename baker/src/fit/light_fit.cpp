// SPDX-License-Identifier: MIT
#include "fit/light_fit.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kPilotSeedOffset = 0x70696C6F;
constexpr int kPilotRounds = 4;  // each linear around the one before
constexpr int kPilotIterations = 12;
// The cost of a round of the pilot (sums of 65 paths, and iterations), in light paths a texel that take as long.
constexpr double kRoundWork = 25;
constexpr uint32_t kRoundRuns = kPilotIterations + 4;
constexpr uint32_t kMostAtOnce = 512, kRounds = 16;  // batches between two calls of `keep`, and calls at least

// The levels of each texel's mean light; of those with few paths nearly their patch's.
void start_from_means(const FitShape& shape, const SortedSamples& samples, const EncodedTone& tone, FitModel& model)
{
    constexpr float kPatchPaths = 4;
    for (uint32_t p = 0; p < shape.mesh.patches.size(); ++p) {
        const PatchRectangle& r = shape.layout.rectangles[p];
        std::vector<Rgb> sums(r.size());
        std::vector<float> counts(r.size());
        Rgb all;
        for (const FitSample* s = samples.begin(p); s != samples.end(p); ++s) {
            sums[s->texel - r.begin] = sums[s->texel - r.begin] + s->radiance;
            counts[s->texel - r.begin] += 1;
            all = all + s->radiance;
        }
        const auto paths = static_cast<float>(samples.end(p) - samples.begin(p));
        const Rgb mean = all * (1 / std::max(paths, 1.0f));
        for (size_t t = 0; t < sums.size(); ++t)
            model.texels[r.begin + t] = tone.encoded((sums[t] + mean * kPatchPaths) * (1 / (counts[t] + kPatchPaths)));
    }
}

struct PilotRound {
    FitModel model;
    std::vector<float> extra_chances;
};

template <class Io>
void fields(Io& io, PilotRound& round)
{
    io(round.model, round.extra_chances);
}

}  // namespace

LightFit::LightFit(const SceneData& scene, const FitShape& shape, const SurfaceSettings& settings, const Shard& shard)
    : shape_(shape),
      settings_(settings),
      tracer_(scene, shape, ViewCap(settings.cap)),
      paths_(settings, shard, shape, tracer_)
{
}

SortedSamples LightFit::by_patch(const SampleBatches& batches) const
{
    return sorted(batches, static_cast<uint32_t>(shape_.mesh.patches.size()));
}

// All shards trace the same pilot.
SortedSamples LightFit::pilot_samples(BakeStages& stages, Job& job) const
{
    SampleBatches all;
    const uint32_t count = paths_.pilot_batches();
    for (uint32_t first = 0; first < count; first += kMostAtOnce) {
        const uint32_t batches = std::min(kMostAtOnce, count - first);
        const uint64_t end = job.part_of_rest(0) + uint64_t{SampleTracer::kLines} * batches;
        const auto traced = [&] {
            SampleBatches samples(batches);
            job.run(batches, [&](uint32_t k) {
                samples[k] = tracer_.samples(settings_.seed + kPilotSeedOffset, first + k);
                job.add_rays(SampleTracer::kLines);
            });
            return samples;
        };
        SampleBatches some = stages.once<SampleBatches>("pilot paths", traced, first);
        job.add_rays(end - job.part_of_rest(0));  // none, unless they were kept
        stages.require_shape(are_of(some, shape_));
        std::move(some.begin(), some.end(), std::back_inserter(all));
    }
    return by_patch(all);
}

void LightFit::pilot(FitState& state, BakeStages& stages, Job& job) const
{
    const SortedSamples samples = pilot_samples(stages, job);
    ViewSmoothness smoothness(shape_);
    start_from_means(shape_, samples, state.tone, state.expected);
    FitSums sums(shape_, state.tone, state.expected, White::goes_on);
    FitSolver solver(sums, smoothness, viewable_vertices(shape_.mesh), job);
    bool is_first = true;  // not of all rounds: others may have been kept
    for (int round = 0; round < kPilotRounds; ++round) {
        const JobStage stage(job, Stage::solving, job.part_of_rest(0) + pilot_work() / kPilotRounds, kRoundRuns);
        const auto next = [&] {
            for_patches(shape_, job, [&](uint32_t p) {
                if (is_first)
                    sums.add(p, samples.begin(p), samples.end(p));
                else
                    sums.add_again(p, samples.begin(p), samples.end(p));
            });
            is_first = false;
            if (round != 0) smoothness.learn(sums, state.expected);
            PilotRound done = {state.expected, paths_.extra_chances(sums)};
            solver.solve(done.model, kPilotIterations);
            return done;
        };
        PilotRound done = stages.once<PilotRound>("pilot fit", next, round);
        const size_t chances = done.extra_chances.size();
        stages.require_shape(is_of(done.model, shape_) && (chances == 0 || chances == shape_.mesh.patches.size()));
        state.expected = std::move(done.model);
        state.extra_chances = std::move(done.extra_chances);
    }
    state.has_pilot = true;
}

uint64_t LightFit::pilot_work() const
{
    return static_cast<uint64_t>(kPilotRounds * kRoundWork * shape_.layout.texels);
}

uint64_t LightFit::work() const
{
    return uint64_t{SampleTracer::kLines} * (uint64_t{paths_.pilot_batches()} + paths_.batches()) + pilot_work();
}

uint64_t LightFit::work_in(const FitState& state) const
{
    const uint64_t pilot = uint64_t{SampleTracer::kLines} * paths_.pilot_batches() + pilot_work();
    return state.has_pilot ? pilot + uint64_t{SampleTracer::kLines} * state.batches : 0;
}

void LightFit::trace(FitState& state, BakeStages& stages, Job& job, const std::function<void()>& keep)
{
    const uint32_t batches = paths_.batches();
    state.wanted = batches;
    const uint32_t at_once = std::clamp(batches / kRounds, 1u, kMostAtOnce);
    if (!state.has_pilot) {
        pilot(state, stages, job);
        keep();
    }
    const ExtraLines extra(shape_, state.extra_chances);
    const ProgressCallback quiet;
    const auto traced = [&](uint32_t count) {
        SampleBatches samples(count);
        job.run(count, [&](uint32_t k) {
            samples[k] = tracer_.samples(settings_.seed, paths_.batch(state.batches + k), &extra);
            job.add_rays(SampleTracer::kLines);
        });
        return samples;
    };
    while (state.batches < batches) {
        const uint32_t count = std::min(at_once, batches - state.batches);
        const SortedSamples samples = by_patch(traced(count));
        Job whole(1, settings_.threads, quiet);  // sums hold all of a batch or nothing
        for_patches(shape_, whole, [&](uint32_t p) { state.sums.add(p, samples.begin(p), samples.end(p)); });
        state.batches += count;
        state.paths += samples.samples.size();
        keep();
        job.finish();  // reports, as it does at the end
    }
    job.finish();
}

}  // namespace lumi::baker
