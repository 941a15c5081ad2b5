// SPDX-License-Identifier: MIT
#include "fit/light_fit.h"

#include "fit/matt_light.h"
#include "fit/texel_finish.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kPilotSeedOffset = 0x70696C6F;
constexpr const char* kPilotPaths = "pilot paths";
constexpr uint32_t kPilotRounds = 4;  // each linear around the one before
constexpr int kPilotIterations = 12;
// The cost of a round of the pilot (its sums, and iterations), in light paths a texel that take as long.
constexpr double kRoundWork = 11;
constexpr double kSumsPart = 0.7;  // of a round
constexpr uint32_t kRoundRuns = kPilotIterations + 4;
constexpr uint32_t kRounds = 16;     // calls of `keep` at least
constexpr double kMostAtOnce = 1e6;  // light paths between two of them: they are kept in memory

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

// Batches of so many lines to a texel.
uint32_t at_once_of(uint32_t lines)
{
    return static_cast<uint32_t>(std::max(1.0, kMostAtOnce / (double{PathPlan::kBatchTexels} * lines)));
}

// So that no sum is kept of tables that the solution would leave out.
void leave_out_flat_tables(const FitSums& sums, FitSolver& solver, FitModel& model)
{
    constexpr double kFlat = 4;  // levels, root mean square; a pilot's tables are not known better
    model.viewed = viewed_vertices(sums, model, kFlat);
    flatten_unviewed(model);
    solver.fit_texels(model);
}

struct PilotRound {
    FitModel model;
    std::vector<uint32_t> lines;
};

template <class Io>
void fields(Io& io, PilotRound& round)
{
    io(round.model, round.lines);
}

}  // namespace

LightFit::LightFit(const SceneData& scene, const FitShape& shape, const SurfaceSettings& settings, const Shard& shard)
    : shape_(shape),
      settings_(settings),
      tracer_(scene, shape, ViewCap(settings.cap)),
      paths_(settings, shard, shape),
      lines_a_path_(lines_a_path())
{
}

// Lines that something stops before they reach their texel are no paths. A few lines tell how many these are.
double LightFit::lines_a_path() const
{
    constexpr uint32_t kBatches = 64;
    constexpr double kMost = 8;  // fit/path_plan.cpp spends no more
    const uint32_t all = paths_.pilot_batches(), step = std::max(1u, all / kBatches);
    double sum = 0, count = 0;
    for (uint32_t k = 0; k < all; k += step) {
        SampleBatches samples(1);
        double lines = 0;
        paths_.each_texel(k, [&](uint32_t patch, uint32_t texel) {
            tracer_.trace(settings_.seed + kPilotSeedOffset, patch, texel, 1, samples[0]);
            lines += 1;
        });
        sum += std::min(kMost, lines / std::max(1.0, static_cast<double>(samples[0].size())));
        count += 1;
    }
    return count > 0 ? sum / count : 1;
}

SortedSamples LightFit::by_patch(const SampleBatches& batches) const
{
    return sorted(batches, static_cast<uint32_t>(shape_.mesh.patches.size()));
}

template <class Number>
SampleBatches LightFit::traced(Number number, uint32_t count, Job& job, uint64_t seed,
                               const std::vector<uint32_t>& lines) const
{
    SampleBatches samples(count);
    job.run(count, [&](uint32_t k) {
        uint64_t all = 0;
        paths_.each_texel(number(k), [&](uint32_t patch, uint32_t texel) {
            tracer_.trace(seed, patch, texel, lines[patch], samples[k]);
            all += lines[patch];
        });
        job.add_rays(all);
    });
    return samples;
}

// All shards trace the same pilot.
SortedSamples LightFit::pilot_samples(BakeStages& stages, Job& job) const
{
    SampleBatches all;
    const std::vector<uint32_t> lines(shape_.mesh.patches.size(), paths_.pilot_lines());
    const uint32_t count = paths_.pilot_batches(), at_once = at_once_of(paths_.pilot_lines());
    for (uint32_t first = 0; first < count; first += at_once) {
        const uint32_t batches = std::min(at_once, count - first);
        const uint64_t end = job.part_of_rest(0) + uint64_t{PathPlan::kBatchTexels} * paths_.pilot_lines() * batches;
        const auto make = [&] {
            return traced([&](uint32_t k) { return first + k; }, batches, job, settings_.seed + kPilotSeedOffset,
                          lines);
        };
        SampleBatches some = stages.once<SampleBatches>(kPilotPaths, make, first);
        job.add_rays(end - job.part_of_rest(0));  // none, unless they were kept
        stages.require_shape(are_of(some, shape_));
        std::move(some.begin(), some.end(), std::back_inserter(all));
    }
    return by_patch(all);
}

void LightFit::pilot(FitState& state, BakeStages& stages, Job& job) const
{
    const SortedSamples samples = pilot_samples(stages, job);
    if (!settings_.view_tables) state.expected.viewed.assign(state.expected.viewed.size(), 0);
    ViewSmoothness smoothness(shape_, state.expected.viewed);
    start_from_means(shape_, samples, state.tone, state.expected);
    const double more = std::max(1.0, 1.0 * settings_.paths_per_texel / paths_.pilot_lines());
    for_patches(shape_, job, [&](uint32_t p) {
        learn_matt_light(shape_, p, samples.begin(p), samples.end(p), more, state.expected);
    });
    FitSums sums(shape_, state.tone, state.expected, White::goes_on);
    sums.weigh(std::vector<uint32_t>(shape_.mesh.patches.size(), paths_.pilot_lines()));
    bool is_first = true;             // not of all rounds: others may have been kept
    std::optional<FitSolver> solver;  // rounds change the targets alone, so its matrices stay
    const uint64_t begin = job.part_of_rest(0);
    const auto require_shape = [&](const PilotRound& round) {
        stages.require_shape(is_of(round.model, shape_) && round.lines.size() == shape_.mesh.patches.size());
    };
    const auto next = [&](uint32_t k, PilotRound& round) {
        const auto end_of = [&](double part) {
            return begin + static_cast<uint64_t>(static_cast<double>(pilot_work()) * (k + part) / kPilotRounds);
        };
        if (k != 0) {
            require_shape(round);
            state.expected = round.model;
        }
        {
            const JobStage stage(job, Stage::solving, end_of(kSumsPart), 1);
            for_patches(shape_, job, [&](uint32_t p) {
                if (is_first)
                    sums.add(p, samples.begin(p), samples.end(p));
                else
                    sums.add_again(p, samples.begin(p), samples.end(p));
            });
        }
        is_first = false;
        const JobStage stage(job, Stage::solving, end_of(1), kRoundRuns);
        if (k != 0) smoothness.learn(sums, state.expected);
        round.model = state.expected;
        if (!solver) solver.emplace(sums, smoothness, round.model.viewed, job);
        solver->solve(round.model, kPilotIterations);
        if (k + 1 == kPilotRounds) leave_out_flat_tables(sums, *solver, round.model);
        round.lines = paths_.lines(sums, round.model.viewed);
        finish_texels(sums, state.tone, round.model);
        return true;
    };
    PilotRound last = stages.in_steps<PilotRound>("pilot fit", kPilotRounds, next);
    require_shape(last);
    job.add_rays(begin + pilot_work() - job.part_of_rest(0));  // none, unless they were kept
    state.expected = std::move(last.model);
    state.lines = std::move(last.lines);
    if (paths_.counts_pilot()) {
        for_patches(shape_, job, [&](uint32_t p) { state.sums.add(p, samples.begin(p), samples.end(p)); });
        state.paths += samples.samples.size();
    }
    state.has_pilot = true;  // whole: what was cancelled before is not kept
}

void LightFit::forget_pilot(BakeStages& stages)
{
    stages.forget_from(kPilotPaths, uint32_t{0});
}

uint64_t LightFit::pilot_work() const
{
    return static_cast<uint64_t>(kPilotRounds * kRoundWork * shape_.layout.texels);
}

uint64_t LightFit::rays_left(const FitState& state) const
{
    if (!state.has_pilot)
        return uint64_t{PathPlan::kBatchTexels} *
               (uint64_t{paths_.pilot_lines()} * paths_.pilot_batches() +
                uint64_t{paths_.after_pilot(static_cast<uint32_t>(lines_a_path_ * paths_.mean_lines()))} *
                    paths_.batches());
    uint64_t rays = 0;
    for (uint32_t k = state.batches; k < paths_.batches(); ++k)
        paths_.each_texel(paths_.batch(k),
                          [&](uint32_t patch, uint32_t) { rays += paths_.after_pilot(state.lines[patch]); });
    return rays;
}

uint64_t LightFit::work_in(const FitState& state) const
{
    const uint64_t pilot =
        uint64_t{PathPlan::kBatchTexels} * paths_.pilot_lines() * paths_.pilot_batches() + pilot_work();
    return state.has_pilot ? pilot + uint64_t{PathPlan::kBatchTexels} * paths_.most_lines() * state.batches : 0;
}

void LightFit::trace(FitState& state, BakeStages& stages, Job& job, const std::function<void()>& keep)
{
    const uint32_t batches = paths_.batches();
    state.wanted = batches;
    if (!state.has_pilot) {
        pilot(state, stages, job);
        keep();
    }
    const uint32_t at_once = std::min(std::max(batches / kRounds, 1u), at_once_of(std::max(paths_.most_lines(), 1u)));
    std::vector<uint32_t> lines = state.lines;
    for (uint32_t& n : lines) n = paths_.after_pilot(n);
    const ProgressCallback as_whole = [&](const Progress&) {
        job.tell();
        return true;
    };
    while (state.batches < batches) {
        const uint32_t count = std::min(at_once, batches - state.batches);
        const SortedSamples samples = by_patch(
            traced([&](uint32_t k) { return paths_.batch(state.batches + k); }, count, job, settings_.seed, lines));
        Job whole(1, settings_.threads, as_whole);  // sums hold all of a batch or nothing
        for_patches(shape_, whole, [&](uint32_t p) { state.sums.add(p, samples.begin(p), samples.end(p)); });
        state.batches += count;
        state.paths += samples.samples.size();
        keep();
        job.finish();  // reports, as it does at the end
    }
    job.finish();
}

}  // namespace lumi::baker
