// SPDX-License-Identifier: MIT
#include "fit/texel_density.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/encoded_tone.h"
#include "fit/sample_tracer.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kSeedOffset = 0x64657461;
constexpr double kLines = 1e6;             // to all cells together, for each half
constexpr double kFewest = 4, kMost = 32;  // to a cell
constexpr double kCells = 2e5;             // at most: more tell no more about where detail is
constexpr uint32_t kFarthest = 8;          // cells between two that are compared
constexpr float kSure = 2.5f;              // standard errors by which a difference must exceed the noise
constexpr float kVisible = 6;              // squared levels of a channel between neighbours: finer texels show no more
constexpr float kLeastCells = 0.25f;       // texels along a line as long as a cell, however even the light
constexpr float kLeastDetail = 12;         // squared levels of all channels: two levels between neighbours
constexpr float kOutline = 10000;          // the same beside a texel that light passes: 60 levels to what lies behind
constexpr float kPower = 0.25f;            // the error of smooth colours falls with the fourth power of the density
constexpr float kThinnest = 0.4f, kDensest = 3;  // times the mean density

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

// Cells of a rectangle, as levels by each half of their paths, and how much the two halves differ by noise.
class Cells
{
public:
    Cells(const std::array<SortedSamples, 2>& samples, uint32_t patch, const PatchRectangle& r, const EncodedTone& tone)
        : width_(r.n), height_(r.m), colours_(r.size())
    {
        std::vector<Halves> cells(r.size());
        for (size_t half = 0; half < 2; ++half) {
            for (const FitSample* s = samples[half].begin(patch); s != samples[half].end(patch); ++s) {
                Halves& cell = cells[s->texel - r.begin];
                cell.sums[half] = cell.sums[half] + s->radiance;
                ++cell.counts[half];
            }
        }
        float count = 0;
        for (size_t t = 0; t < cells.size(); ++t) {
            known_.push_back(cells[t].known());
            if (!known_[t]) continue;
            for (size_t half = 0; half < 2; ++half)
                colours_[t][half] = tone.encoded(cells[t].sums[half] * (1 / static_cast<float>(cells[t].counts[half])));
            for (size_t c = 0; c < 3; ++c) {
                const float off = colours_[t][0][c] - colours_[t][1][c];
                noise_ += off * off / 2;
            }
            ++count;
        }
        noise_ /= std::max(count, 1.0f);
    }

    // The mean squared difference of all channels between cells that lie `step` apart, as far as it is no noise, for
    // neighbours: that of an even slope grows with the square of the step, noise does not.
    float slope(uint32_t step) const
    {
        float sum = 0, pairs = 0;
        const auto compare = [&](size_t a, size_t b) {
            if (!known_[a] || !known_[b]) return;
            sum += product(colours_[a], colours_[b]);
            ++pairs;
        };
        each_pair(step, compare);
        if (pairs == 0) return 0;
        const float uncertain = kSure * 2 * noise_ / std::sqrt(pairs);
        return std::max(0.0f, sum / pairs - uncertain) / static_cast<float>(step * step);
    }

    // The share of neighbours of which light passes one.
    float outline() const
    {
        float edges = 0, pairs = 0;
        each_pair(1, [&](size_t a, size_t b) {
            edges += known_[a] != known_[b] ? 1.0f : 0.0f;
            pairs += known_[a] || known_[b] ? 1.0f : 0.0f;
        });
        return edges / std::max(pairs, 1.0f);
    }

private:
    template <class Function>
    void each_pair(uint32_t step, Function f) const
    {
        for (uint32_t y = 0; y < height_; ++y) {
            for (uint32_t x = 0; x < width_; ++x) {
                const size_t here = size_t{y} * width_ + x;
                if (x + step < width_) f(here, here + step);
                if (y + step < height_) f(here, here + size_t{step} * width_);
            }
        }
    }

    const uint32_t width_, height_;
    std::vector<std::array<LevelColour, 2>> colours_;
    std::vector<bool> known_;
    float noise_ = 0;  // the variance of a half, all channels
};

PatchDetail detail_of(const std::array<SortedSamples, 2>& samples, uint32_t patch, const PatchRectangle& r,
                      const EncodedTone& tone, bool see_through)
{
    const Cells cells(samples, patch, r, tone);
    PatchDetail result;
    for (uint32_t step = 1; step <= kFarthest; step *= 2) result.detail = std::max(result.detail, cells.slope(step));
    if (see_through) result.detail += kOutline * cells.outline();
    for (const SortedSamples& half : samples)
        result.seen += static_cast<float>(half.end(patch) - half.begin(patch)) / static_cast<float>(r.size());
    return result;
}

// As dense as can be with so many texels in all, in the mean `density`, nowhere above `finest`.
std::vector<float> within(uint32_t texels, const PatchMesh& mesh, const std::vector<float>& importance, float density,
                          float finest)
{
    constexpr int kHalvings = 20;
    const auto scaled = [&](float factor) {
        std::vector<float> densities;
        for (const float i : importance)
            densities.push_back(std::min(density * std::clamp(factor * i, kThinnest, kDensest), finest));
        return densities;
    };
    float low = 0, high = 16;
    for (int k = 0; k < kHalvings; ++k) {
        const float middle = 0.5f * (low + high);
        (unlimited_layout(mesh, scaled(middle)).texels <= texels ? low : high) = middle;
    }
    return scaled(low);
}

// So many texels show what there is: one patch's detail is known badly, their sum well.
uint32_t needed_texels(const PatchMesh& mesh, const std::vector<float>& details, float cells_per_radius)
{
    std::vector<float> densities;
    for (const float d : details)
        densities.push_back(cells_per_radius * std::max(kLeastCells, std::sqrt(d / 3 / kVisible)));
    return unlimited_layout(mesh, densities).texels;
}

SortedSamples traced(const SampleTracer& tracer, const FitShape& shape, uint64_t seed, uint32_t lines, Job& job)
{
    constexpr uint32_t kPatchesATask = 16;
    const auto patches = static_cast<uint32_t>(shape.mesh.patches.size());
    std::vector<std::vector<FitSample>> samples((patches + kPatchesATask - 1) / kPatchesATask);
    job.run(static_cast<uint32_t>(samples.size()), [&](uint32_t k) {
        for (uint32_t p = k * kPatchesATask; p < std::min(patches, (k + 1) * kPatchesATask); ++p) {
            const uint32_t texels = shape.layout.rectangles[p].size();
            for (uint32_t t = 0; t < texels; ++t) tracer.trace(seed, p, t, lines, samples[k]);
            job.add_rays(uint64_t{texels} * lines);
        }
    });
    return sorted(samples, patches);
}

}  // namespace

std::vector<float> texel_densities(const std::vector<DensityLight>& lights, const PatchMesh& mesh,
                                   const SurfaceSettings& settings, const ProgressCallback& progress)
{
    const uint32_t allowed = layout_of(mesh, settings.texels_per_radius).texels;
    const float coarse = settings.texels_per_radius * static_cast<float>(std::sqrt(std::min(1.0, kCells / allowed)));
    const FitShape shape(mesh, std::vector<float>(mesh.patches.size(), coarse));
    const auto patches = static_cast<uint32_t>(mesh.patches.size()), count = static_cast<uint32_t>(lights.size());
    const auto lines = static_cast<uint32_t>(std::clamp(kLines / shape.layout.texels, kFewest, kMost));
    Job job(uint64_t{2} * count * lines * shape.layout.texels, settings.threads, progress);
    const JobStage stage(job, Stage::mesh, job.part_of_rest(1), 2 * count);
    const float finer = settings.texels_per_radius / coarse;
    std::vector<float> importance(patches), details(patches);
    for (const DensityLight& light : lights) {
        const SampleTracer tracer(light.scene, shape, ViewCap(settings.cap));
        const EncodedTone tone(light.scene.tone);
        const auto half = [&](uint64_t k) {
            return traced(tracer, shape, settings.seed + kSeedOffset + k, lines, job);
        };
        const std::array<SortedSamples, 2> samples = {half(0), half(1)};
        const auto paths = static_cast<float>(samples[0].samples.size() + samples[1].samples.size());
        const float usual = std::max(paths / static_cast<float>(shape.layout.texels), 1e-6f);
        for (uint32_t p = 0; p < patches; ++p) {
            PatchDetail d = detail_of(samples, p, shape.layout.rectangles[p], tone, p >= mesh.opaque_patches());
            d.detail *= light.times * light.times;
            const float detail = d.detail / (finer * finer) + kLeastDetail;
            importance[p] = std::max(importance[p], std::pow(d.seen / usual * detail / kLeastDetail, kPower));
            details[p] = std::max(details[p], d.detail);
        }
    }
    const uint32_t texels = settings.fills ? allowed : std::min(allowed, needed_texels(mesh, details, coarse));
    // The range of densities is one around the mean.
    const float density =
        settings.texels_per_radius * std::sqrt(static_cast<float>(texels) / static_cast<float>(allowed));
    constexpr float kAny = std::numeric_limits<float>::infinity();
    return within(texels, mesh, importance, density, settings.fills ? kAny : settings.finest_texels);
}

}  // namespace lumi::baker
