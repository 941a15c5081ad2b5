// SPDX-License-Identifier: MIT
#include "fit/sample_tracer.h"

#include "math/warp.h"
#include "mesh/survey.h"
#include "trace/hit_point.h"

namespace lumi::baker
{
namespace
{

// View tables are read in the direction from a vertex to the eye, so the fit needs eyes: they are as far off as
// pictures are mostly drawn from, in radii from the centre.
constexpr float kEyeDistance = 3;

Mesh triangles_of(const PatchMesh& mesh, std::vector<uint32_t>& numbers)
{
    Mesh result;
    result.positions = mesh.positions;
    for (uint32_t p = 0; p < mesh.patches.size(); ++p) {
        const PatchMesh::Patch& patch = mesh.patches[p];
        result.corners.push_back({patch.a, patch.b, patch.c});
        numbers.push_back(2 * p);
        if (patch.d != PatchMesh::kNone) {
            result.corners.push_back({patch.d, patch.c, patch.b});
            numbers.push_back(2 * p + 1);
        }
    }
    return result;
}

Vec3 eye_of(const Ray& ray)
{
    const float along = dot(ray.origin, ray.direction);
    const float back = along + std::sqrt(along * along + kEyeDistance * kEyeDistance - dot(ray.origin, ray.origin));
    return ray.origin - ray.direction * back;
}

int16_t q12(float v)
{
    return static_cast<int16_t>(std::lround(v * kEyeScale));
}

}  // namespace

SampleTracer::SampleTracer(const SceneData& scene, const FitShape& shape, const ViewCap& cap)
    : scene_(scene), shape_(shape), cap_(cap), mesh_(triangles_of(shape.mesh, numbers_), Faces::front), tracer_(scene)
{
}

std::optional<SampleTracer::Line> SampleTracer::line(Sampler& sampler) const
{
    const Vec3 direction = square_to_sphere(sampler.next_2d());
    const Vec2 place = square_to_disc(sampler.next_2d());
    const Frame frame(direction);
    const float inwards = std::sqrt(std::max(0.0f, 1 - place.x * place.x - place.y * place.y));
    const Ray ray = {frame.to_world({place.x, place.y, -inwards}), direction};
    const std::optional<Hit> hit = cap_.sees(ray) ? mesh_.closest(ray) : std::nullopt;
    return hit ? std::optional<Line>({ray, *hit}) : std::nullopt;
}

bool SampleTracer::scene_is_there(const Line& line, Sampler sampler) const
{
    return std::abs(first_meeting(scene_, line.ray, sampler) - line.hit.distance) <= kMaxDepthError;
}

FitSample SampleTracer::sample(const Line& line, const Rgb& radiance) const
{
    const uint32_t triangle = numbers_[line.hit.triangle];
    const PatchRectangle& rectangle = shape_.layout.rectangles[triangle / 2];
    const Vec3 eye = eye_of(line.ray);
    return {triangle,
            texel_at(rectangle, triangle % 2 != 0, line.hit.u, line.hit.v),
            q12(line.hit.u),
            q12(line.hit.v),
            {q12(eye.x), q12(eye.y), q12(eye.z)},
            radiance};
}

std::vector<FitSample> SampleTracer::samples(uint64_t seed, uint32_t batch) const
{
    std::vector<FitSample> result;
    Sampler sampler(seed, batch, 0);
    for (uint32_t k = 0; k < kLines; ++k) {
        sampler.start(k);
        const std::optional<Line> l = line(sampler);
        if (!l || !scene_is_there(*l, sampler))  // the path's first hit draws the same numbers
            continue;
        const PathResult path = tracer_.trace(l->ray, sampler);
        if (path.covered) result.push_back(sample(*l, path.radiance));
    }
    return result;
}

SampleTracer::Meeting SampleTracer::meeting(uint64_t seed, uint32_t batch) const
{
    Meeting result;
    Sampler sampler(seed, batch, 0);
    for (uint32_t k = 0; k < kLines; ++k) {
        sampler.start(k);
        if (const std::optional<Line> l = line(sampler)) {
            ++result.mesh;
            result.scene += scene_is_there(*l, sampler) ? 1u : 0u;
        }
    }
    return result;
}

bool are_of(const SampleBatches& batches, const FitShape& shape)
{
    for (const std::vector<FitSample>& batch : batches) {
        for (const FitSample& s : batch) {
            const uint32_t patch = s.triangle / 2;
            if (patch >= shape.mesh.patches.size()) return false;
            const PatchRectangle& rectangle = shape.layout.rectangles[patch];
            if (s.texel - rectangle.begin >= rectangle.size()) return false;
        }
    }
    return true;
}

SortedSamples sorted(const std::vector<std::vector<FitSample>>& batches, uint32_t patches)
{
    SortedSamples result;
    result.begins.assign(patches + 1, 0);
    for (const std::vector<FitSample>& batch : batches)
        for (const FitSample& s : batch) ++result.begins[s.triangle / 2 + 1];
    for (uint32_t p = 0; p < patches; ++p) result.begins[p + 1] += result.begins[p];
    std::vector<size_t> next(result.begins.begin(), result.begins.end() - 1);
    result.samples.resize(result.begins.back());
    for (const std::vector<FitSample>& batch : batches)
        for (const FitSample& s : batch) result.samples[next[s.triangle / 2]++] = s;
    return result;
}

}  // namespace lumi::baker
