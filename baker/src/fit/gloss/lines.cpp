// SPDX-License-Identifier: MIT
#include "fit/gloss/lines.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "fit/sample_tracer.h"
#include "math/warp.h"
#include "mesh/mesh_tracer.h"
#include "mesh/survey.h"
#include "scene/moving_parts.h"
#include "trace/hit_point.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{
namespace
{

constexpr uint32_t kLinesABatch = 4096, kLinesATexel = 11, kFewestBatches = 25, kMostBatches = 400;
constexpr uint32_t kPathsAHalf = 2;  // of a line: from one path alone no map can be learnt
constexpr uint64_t kSeedOffset = 0x61055;
constexpr float kWhitest = 255, kNotSmooth = -1;

float& channel(Rgb& c, size_t k)
{
    return k == 0 ? c.r : k == 1 ? c.g : c.b;
}

// Levels are a concave function f of radiance, so the mean of noisy light looks darker than it is: by f''/2 times its
// variance, which two halves of the paths tell that know nothing of each other.
void set_levels(GlossLine& line, const EncodedTone& tone, Rgb first, Rgb second)
{
    Rgb mean = (first + second) * 0.5f;
    line.levels = tone.encoded(mean);
    line.noise = 0;
    for (size_t k = 0; k < 3; ++k) {
        const float x = channel(mean, k), step = x / 4, off = (channel(first, k) - channel(second, k)) / 2;
        if (!(step > 0)) continue;
        const auto at = [&](float value) {
            Rgb other = mean;
            channel(other, k) = value;
            return tone.encoded(other)[k];
        };
        const float below = at(x - step), here = line.levels[k], above = at(x + step);
        const float slope = (above - below) / (2 * step), bend = (above - 2 * here + below) / (step * step);
        line.levels[k] = std::min(here - bend * std::min(off * off, x * x / 2) / 2, kWhitest);
        line.noise += slope * slope * off * off;
    }
}

class LineTracer
{
public:
    LineTracer(const SceneData& scene, const FitShape& shape, const SurfaceSettings& settings)
        : body_(shape.mesh.parts.empty() ? nullptr : only_of(scene, 0)),
          scene_(body_ ? *body_ : scene),
          shape_(shape),
          cap_(settings.cap),
          seed_(settings.seed + kSeedOffset),
          mesh_(triangles_of(shape.mesh, 0, numbers_), Faces::front),
          tracer_(scene_),
          tone_(scene.tone)
    {
        for (const Material& material : scene.materials) smooth_.push_back(is_smooth(material));
    }

    // Those to smooth surfaces have levels, the others kNotSmooth.
    std::vector<GlossLine> batch(uint32_t number) const
    {
        std::vector<GlossLine> lines;
        Sampler sampler(seed_, number, 0);
        for (uint32_t k = 0; k < kLinesABatch; ++k) {
            sampler.start(k);
            GlossLine line;
            Ray ray;
            if (!meets(sampler, ray, line)) continue;
            if (line.noise == kNotSmooth || trace(ray, number * kLinesABatch + k, line)) lines.push_back(line);
        }
        return lines;
    }

private:
    bool meets(Sampler& sampler, Ray& ray, GlossLine& line) const
    {
        const Vec3 direction = square_to_sphere(sampler.next_2d());
        const Vec2 place = square_to_disc(sampler.next_2d());
        const float inwards = std::sqrt(std::max(0.0f, 1 - place.x * place.x - place.y * place.y));
        ray = {Frame(direction).to_world({place.x, place.y, -inwards}), direction};
        if (!cap_.sees(ray)) return false;
        std::vector<Hit> passed;
        const std::optional<Hit> seen = closest_opaque(scene_, ray, sampler, passed), hit = mesh_.closest(ray);
        if (!seen || !hit || std::abs(seen->distance - hit->distance) > kMaxDepthError) return false;
        line.material = scene_.mesh.materials[seen->triangle];
        line.noise = smooth_[line.material] ? 0 : kNotSmooth;
        line.normal = hit_point_at(scene_, ray, *seen).frame.normal;
        line.triangle = numbers_[hit->triangle];
        line.texel = texel_at(shape_.layout.rectangles[line.triangle / 2], line.triangle % 2 != 0, hit->u, hit->v);
        line.second = hit->u;
        line.third = hit->v;
        line.eye = eye_of(ray);
        // Panes tint what is drawn behind them, so its light begins behind the last of them.
        if (!passed.empty()) ray.origin = ray.origin + ray.direction * ((passed.back().distance + seen->distance) / 2);
        return true;
    }

    bool trace(const Ray& ray, uint32_t number, GlossLine& line) const
    {
        std::array<Rgb, 2> halves;
        for (uint32_t half = 0; half < halves.size(); ++half) {
            Sampler sampler(seed_ + 1, number, half);
            for (uint32_t k = 0; k < kPathsAHalf; ++k) {
                sampler.start(k);
                const PathResult path = tracer_.trace(ray, sampler);
                if (!path.covered) return false;
                halves[half] = halves[half] + path.radiance * (1.0f / kPathsAHalf);
            }
        }
        set_levels(line, tone_, halves[0], halves[1]);
        return true;
    }

    const std::unique_ptr<SceneData> body_;  // without what moves, which has no maps
    const SceneData& scene_;
    const FitShape& shape_;
    const ViewCap cap_;
    const uint64_t seed_;
    std::vector<uint32_t> numbers_;
    const MeshTracer mesh_;
    const PathTracer tracer_;
    const EncodedTone tone_;
    std::vector<bool> smooth_;
};

using Batches = std::vector<std::vector<GlossLine>>;
constexpr char kKept[] = "gloss lines";

// Whether all lie on the mesh.
bool are_of(const Batches& batches, const FitShape& shape, const SceneData& scene)
{
    return std::all_of(
        batches.begin(), batches.end(),
        [&](const std::vector<GlossLine>& batch) {
            return std::all_of(
                batch.begin(), batch.end(),
                [&](const GlossLine& line) {
                    return line.triangle / 2 < shape.mesh.patches.size() && line.texel < shape.layout.texels &&
                           line.material < scene.materials.size();
                });
        });
}

}  // namespace

bool is_smooth(const Material& material)
{
    constexpr float kMostAlpha = 0.36f;  // a roughness of 0.6: wider lobes view tables hold as well
    const bool shines = material.specular || material.metalness > 0 || material.maps.metalness.used();
    const bool is_sharp = material.alpha <= kMostAlpha || material.maps.roughness.used() ||
                          (material.coat > 0 && material.coat_alpha <= kMostAlpha);
    return (shines || material.coat > 0) && is_sharp && !material.glass && !material.may_pass();
}

GlossLines gloss_lines(const SceneData& scene, const FitShape& shape, const SurfaceSettings& settings,
                       BakeStages& stages, Job& job)
{
    constexpr uint32_t kBatchesAtOnce = 50;
    const LineTracer tracer(scene, shape, settings);
    const uint32_t wanted = shape.layout.texels * kLinesATexel / kLinesABatch;
    const uint32_t count = std::clamp(wanted, kFewestBatches, kMostBatches);
    Batches batches;
    for (uint32_t first = 0; first < count; first += kBatchesAtOnce) {
        const auto make = [&] {
            Batches some(std::min(kBatchesAtOnce, count - first));
            job.run(static_cast<uint32_t>(some.size()), [&](uint32_t k) { some[k] = tracer.batch(first + k); });
            return some;
        };
        Batches some = stages.once<Batches>(kKept, make, first);
        stages.require_shape(are_of(some, shape, scene));
        std::move(some.begin(), some.end(), std::back_inserter(batches));
    }
    GlossLines result;
    result.others.resize(shape.mesh.patches.size());
    for (const std::vector<GlossLine>& batch : batches) {
        for (const GlossLine& line : batch)
            if (line.noise == kNotSmooth)
                ++result.others[line.triangle / 2];
            else
                result.lines.push_back(line);
    }
    std::stable_sort(result.lines.begin(), result.lines.end(),
                     [](const GlossLine& a, const GlossLine& b) { return a.texel < b.texel; });
    return result;
}

void forget_gloss_lines(BakeStages& stages)
{
    stages.forget_from(kKept, uint32_t{0});
}

}  // namespace lumi::baker
