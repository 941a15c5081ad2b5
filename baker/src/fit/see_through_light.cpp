// SPDX-License-Identifier: MIT
#include "fit/see_through_light.h"

#include <algorithm>
#include <cmath>

namespace lumi::baker
{
namespace
{

constexpr uint64_t kPassingSeedOffset = 0x70617373;
constexpr double kPassingPaths = 48;            // a see-through texel
constexpr double kMostPassingPaths = 1e7;       // for all of them together
constexpr double kPatchPassingPaths = 8;        // the weight of a patch's mean light in each of its texels, in paths
constexpr double kPatchOpacityPaths = 0.5;      // that of its mean opacity, which is read and has no noise
constexpr uint32_t kPassingBatchesAtOnce = 64;  // batches
constexpr uint32_t kMostPassingBatches = 1u << 14;

struct PassingSums {
    double paths = 0, opacity = 0, passed = 0, covered = 0;
    std::array<double, 3> through{}, radiance{};

    void add(const PassingSample& s)
    {
        paths += 1;
        opacity += static_cast<double>(s.opacity);
        passed += s.passes ? 1 : 0;
        covered += s.covered ? 1 : 0;
        add(through, {s.through.r, s.through.g, s.through.b}, 1);
        if (s.covered) add(radiance, {s.radiance.r, s.radiance.g, s.radiance.b}, 1);
    }
    void add(const PassingSums& s, double weight)
    {
        paths += weight * s.paths;
        opacity += weight * s.opacity;
        passed += weight * s.passed;
        covered += weight * s.covered;
        add(through, s.through, weight);
        add(radiance, s.radiance, weight);
    }
    static void add(std::array<double, 3>& sum, const std::array<double, 3>& s, double weight)
    {
        for (size_t c = 0; c < 3; ++c) sum[c] += weight * s[c];
    }
    SeeThroughTexel texel() const
    {
        SeeThroughTexel t;
        if (paths > 0) t.coverage = static_cast<float>(opacity / paths);
        if (passed > 0) t.open = static_cast<float>(1 - covered / passed);
        t.through = mean(through, paths);
        t.behind = mean(radiance, covered);
        return t;
    }
    static Rgb mean(const std::array<double, 3>& sum, double weight)
    {
        const auto channel = [&](size_t c) { return weight > 0 ? static_cast<float>(sum[c] / weight) : 0.0f; };
        return {channel(0), channel(1), channel(2)};
    }
};

std::vector<PassingSums> passing_sums(const SampleTracer& tracer, uint64_t seed, uint32_t texels, double paths,
                                      Job& job)
{
    std::vector<PassingSums> sums(texels);
    double got = 0;
    for (uint32_t first = 0; first < kMostPassingBatches && got < paths; first += kPassingBatchesAtOnce) {
        std::vector<std::vector<PassingSample>> batches(kPassingBatchesAtOnce);
        job.run(kPassingBatchesAtOnce, [&](uint32_t k) { batches[k] = tracer.passing(seed, first + k); });
        for (const std::vector<PassingSample>& batch : batches) {
            for (const PassingSample& s : batch) sums[s.texel].add(s);
            got += static_cast<double>(batch.size());
        }
        if (got == 0) break;
    }
    return sums;
}

}  // namespace

std::vector<SeeThroughTexel> see_through_light(const SceneData& scene, const FitShape& shape,
                                               const SurfaceSettings& settings, const ProgressCallback& progress)
{
    if (shape.mesh.see_through_patches == 0) return {};
    const SampleTracer tracer(scene, shape, ViewCap(settings.cap));
    double texels = 0;
    for (size_t p = shape.mesh.opaque_patches(); p < shape.mesh.patches.size(); ++p)
        texels += shape.layout.rectangles[p].size();
    const double paths = std::min(kPassingPaths * texels, kMostPassingPaths);
    Job job(static_cast<uint64_t>(paths), settings.threads, progress);
    const JobStage stage(job, Stage::mesh, job.part_of_rest(1), kMostPassingBatches / kPassingBatchesAtOnce);
    const std::vector<PassingSums> sums =
        passing_sums(tracer, settings.seed + kPassingSeedOffset, shape.layout.texels, paths, job);
    std::vector<SeeThroughTexel> result(shape.layout.texels);
    for (size_t p = shape.mesh.opaque_patches(); p < shape.mesh.patches.size(); ++p) {
        const PatchRectangle& r = shape.layout.rectangles[p];
        PassingSums patch;
        for (uint32_t t = r.begin; t < r.begin + r.size(); ++t) patch.add(sums[t], 1);
        for (uint32_t t = r.begin; t < r.begin + r.size(); ++t) {
            const auto with_mean = [&](double weight) {
                PassingSums texel = sums[t];
                texel.add(patch, weight / std::max(1.0, patch.paths));
                return texel.texel();
            };
            result[t] = with_mean(kPatchPassingPaths);
            const SeeThroughTexel read = with_mean(kPatchOpacityPaths);
            result[t].coverage = read.coverage;
            result[t].through = read.through;
        }
    }
    return result;
}

}  // namespace lumi::baker
