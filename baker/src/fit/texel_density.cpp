// SPDX-License-Identifier: MIT
#include "fit/texel_density.h"

#include "fit/encoded_tone.h"
#include "fit/sample_tracer.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kSeedOffset = 0x64657461;
constexpr double kPaths = 24;       // a texel
constexpr double kMaxPaths = 8e6;   // for all texels together: they are kept in memory
constexpr float kLeastDetail = 12;  // squared levels of all channels: two levels between neighbours
constexpr float kOutline = 10000;   // the same beside a texel that light passes: 60 levels to what lies behind
constexpr float kPower = 0.25f;     // the error of smooth colours falls with the fourth power of the density
constexpr float kThinnest = 0.4f, kDensest = 3;  // times the mean density
constexpr uint32_t kMostBatches = 1u << 20;

// Texels by two halves of their paths, whose noise has nothing in common.
struct Halves {
    std::array<Rgb, 2> sums;
    std::array<uint32_t, 2> counts{};

    bool known() const { return counts[0] != 0 && counts[1] != 0; }
};

struct PatchDetail {
    float detail = 0;  // the mean squared difference of neighbouring texels
    float seen = 0;    // light paths a texel
};

float product(const std::array<LevelColour, 2>& a, const std::array<LevelColour, 2>& b)
{
    float sum = 0;
    for (size_t c = 0; c < 3; ++c) sum += (a[0][c] - b[0][c]) * (a[1][c] - b[1][c]);
    return sum;
}

std::vector<Halves> halves_of(const SortedSamples& samples, uint32_t patch, const PatchRectangle& r)
{
    std::vector<Halves> texels(r.size());
    for (const FitSample* s = samples.begin(patch); s != samples.end(patch); ++s) {
        Halves& texel = texels[s->texel - r.begin];
        const size_t half = texel.counts[0] > texel.counts[1] ? 1 : 0;
        texel.sums[half] = texel.sums[half] + s->radiance;
        ++texel.counts[half];
    }
    return texels;
}

PatchDetail detail_of(const SortedSamples& samples, uint32_t patch, const PatchRectangle& r, const EncodedTone& tone,
                      bool see_through)
{
    const std::vector<Halves> texels = halves_of(samples, patch, r);
    std::vector<std::array<LevelColour, 2>> colours(texels.size());
    for (size_t t = 0; t < texels.size(); ++t) {
        for (size_t half = 0; half < 2; ++half) {
            const float count = static_cast<float>(std::max(texels[t].counts[half], 1u));
            colours[t][half] = tone.encoded(texels[t].sums[half] * (1 / count));
        }
    }
    PatchDetail result;
    float pairs = 0;
    const auto compare = [&](size_t a, size_t b) {
        if (texels[a].known() && texels[b].known()) {
            result.detail += product(colours[a], colours[b]);
            ++pairs;
        } else if (see_through && (texels[a].known() || texels[b].known())) {
            result.detail += kOutline;
            ++pairs;
        }
    };
    for (uint32_t t = 0; t < texels.size(); ++t) {
        if (t % r.n + 1 < r.n) compare(t, t + 1);
        if (t + r.n < texels.size()) compare(t, t + r.n);
    }
    result.detail = std::max(0.0f, result.detail / std::max(pairs, 1.0f));
    result.seen = static_cast<float>(samples.end(patch) - samples.begin(patch)) / static_cast<float>(r.size());
    return result;
}

std::vector<float> scaled(const std::vector<float>& importance, float density, float factor)
{
    std::vector<float> densities;
    for (const float v : importance) densities.push_back(density * std::clamp(factor * v, kThinnest, kDensest));
    return densities;
}

// As dense as can be with so many texels in all.
std::vector<float> within(uint32_t texels, const PatchMesh& mesh, const std::vector<float>& importance, float density)
{
    constexpr int kHalvings = 20;
    float low = 0, high = 16;
    for (int k = 0; k < kHalvings; ++k) {
        const float middle = 0.5f * (low + high);
        (unlimited_layout(mesh, scaled(importance, density, middle)).texels <= texels ? low : high) = middle;
    }
    return scaled(importance, density, low);
}

SortedSamples traced(const SampleTracer& tracer, uint64_t seed, double paths, uint32_t patches, Job& job)
{
    const uint32_t found = tracer.meeting(seed, 0).scene;
    const double batches = std::ceil(paths / std::max(1u, found));
    std::vector<std::vector<FitSample>> samples(static_cast<size_t>(std::min<double>(batches, kMostBatches)));
    job.run(static_cast<uint32_t>(samples.size()), [&](uint32_t k) { samples[k] = tracer.samples(seed, k); });
    return sorted(samples, patches);
}

}  // namespace

std::vector<float> texel_densities(const SceneData& scene, const PatchMesh& mesh, const SurfaceSettings& settings,
                                   const ProgressCallback& progress)
{
    const std::vector<float> even(mesh.patches.size(), settings.texels_per_radius);
    const FitShape shape(mesh, even);
    const SampleTracer tracer(scene, shape, ViewCap(settings.cap));
    const EncodedTone tone(scene.tone);
    const auto patches = static_cast<uint32_t>(mesh.patches.size());
    const double paths = std::min(kPaths * shape.layout.texels, kMaxPaths);
    Job job(static_cast<uint64_t>(paths), settings.threads, progress);
    const JobStage stage(job, Stage::mesh, job.part_of_rest(1), 1);
    const SortedSamples samples = traced(tracer, settings.seed + kSeedOffset, paths, patches, job);
    const float usual = static_cast<float>(samples.samples.size()) / static_cast<float>(shape.layout.texels);
    std::vector<float> importance;
    for (uint32_t p = 0; p < patches; ++p) {
        const PatchDetail d = detail_of(samples, p, shape.layout.rectangles[p], tone, p >= mesh.opaque_patches());
        const float seen = d.seen / std::max(usual, 1e-6f);
        importance.push_back(std::pow(seen * (d.detail + kLeastDetail) / kLeastDetail, kPower));
    }
    return within(shape.layout.texels, mesh, importance, settings.texels_per_radius);
}

}  // namespace lumi::baker
