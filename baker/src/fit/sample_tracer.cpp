// SPDX-License-Identifier: MIT
#include "fit/sample_tracer.h"

#include <array>

#include "math/warp.h"
#include "mesh/see_through.h"
#include "mesh/survey.h"
#include "trace/hit_point.h"

namespace lumi::baker
{
namespace
{

// Returns the factor of light on a path that passes there. Chance thins paths by the opacity, so only the hue is left.
Rgb colour_of_pass(const SceneData& scene, const Hit& pane, const Vec3& direction)
{
    return passing_light(scene, pane, direction) * (1 / (1 - opacity_of(scene, pane)));
}

// The light before panes of these colours; 0 in channels of which nothing passes.
Rgb before_panes(const Rgb& light, const Rgb& panes)
{
    const auto channel = [](float after, float share) { return share > 0 ? after / share : 0.0f; };
    return {channel(light.r, panes.r), channel(light.g, panes.g), channel(light.b, panes.b)};
}

int16_t q12(float v)
{
    return static_cast<int16_t>(std::lround(v * kEyeScale));
}

}  // namespace

Vec3 eye_of(const Ray& ray)
{
    constexpr float kEyeDistance = 3;
    const float along = dot(ray.origin, ray.direction);
    const float back = along + std::sqrt(along * along + kEyeDistance * kEyeDistance - dot(ray.origin, ray.origin));
    return ray.origin - ray.direction * back;
}

SampleTracer::SampleTracer(const SceneData& scene, const FitShape& shape, const ViewCap& cap)
    : lit_(scene),
      scene_(lit_.body()),
      shape_(shape),
      cap_(cap),
      see_through_(shape.mesh.see_through_patches != 0 ? see_through_materials(scene_) : std::vector<bool>()),
      mesh_(triangles_of(shape.mesh, 0, numbers_), Faces::front),
      see_through_mesh_(see_through_triangles(shape.mesh, see_through_numbers_), Faces::front),
      tracer_(scene_)
{
    for (uint32_t owner = 1; owner <= shape.mesh.parts.size(); ++owner)
        parts_.push_back(std::make_unique<PartTracer>(lit_.poses(owner), shape.mesh, owner));
}

std::optional<Ray> SampleTracer::ray(Sampler& sampler) const
{
    const Vec3 direction = square_to_sphere(sampler.next_2d());
    const Vec2 place = square_to_disc(sampler.next_2d());
    const Frame frame(direction);
    const float inwards = std::sqrt(std::max(0.0f, 1 - place.x * place.x - place.y * place.y));
    const Ray ray = {frame.to_world({place.x, place.y, -inwards}), direction};
    return cap_.sees(ray) ? std::optional<Ray>(ray) : std::nullopt;
}

std::optional<SampleTracer::Line> SampleTracer::line_to_mesh(const Ray& ray) const
{
    std::optional<Hit> hit = mesh_.closest(ray);
    if (!hit) return std::nullopt;
    hit->triangle = numbers_[hit->triangle];
    return Line{ray, *hit, grey(1)};
}

// The path's first hit draws the same numbers again.
std::optional<SampleTracer::Line> SampleTracer::line(const Ray& ray, Sampler& sampler) const
{
    if (!see_through_.empty()) return see_through_line(ray, sampler);
    const std::optional<Line> l = line_to_mesh(ray);
    return l && scene_is_there(*l, sampler) ? l : std::nullopt;
}

bool SampleTracer::is_see_through(const Hit& in_scene) const
{
    return see_through_[scene_.mesh.materials[in_scene.triangle]];
}

std::optional<SampleTracer::Line> SampleTracer::line_to(const Ray& ray, const Hit& in_scene) const
{
    const bool passes = is_see_through(in_scene);
    std::optional<Hit> hit =
        passes ? see_through_mesh_.near(ray, in_scene.distance, kMaxDepthError) : mesh_.closest(ray);
    if (!hit || std::abs(hit->distance - in_scene.distance) > kMaxDepthError) return std::nullopt;
    hit->triangle = (passes ? see_through_numbers_ : numbers_)[hit->triangle];
    return Line{ray, *hit, grey(1)};
}

std::optional<SampleTracer::Line> SampleTracer::see_through_line(const Ray& ray, Sampler ahead) const
{
    std::vector<Hit> passed;
    const std::optional<Hit> hit = closest_opaque(scene_, ray, ahead, passed);
    std::optional<Line> line = hit ? line_to(ray, *hit) : std::nullopt;
    for (const Hit& pane : passed)
        if (line) line->panes = line->panes * colour_of_pass(scene_, pane, ray.direction);
    return line;
}

SampleTracer::PartTracer::PartTracer(const std::vector<LitPose>& lit, const PatchMesh& of, uint32_t owner)
    : poses(lit), light_stays(of.parts[owner - 1].light_stays), mesh(triangles_of(of, owner, numbers), Faces::front)
{
}

// One of the poses in which the part can be seen along the line, by chance. Where it lies within the body in all of
// them, one of all: what hides it there may not in another.
const LitPose& SampleTracer::pose_along(const Ray& ray, float distance, const PartTracer& part, Sampler& sampler) const
{
    constexpr float kOutside = 2;  // so far back no pose of the line begins within the sphere
    if (part.poses.size() == 1) return part.poses[0];
    const Ray from_outside = {ray.origin - ray.direction * kOutside, ray.direction};
    std::array<const LitPose*, kMostLitPoses> seen;
    size_t count = 0;
    for (const LitPose& pose : part.poses) {
        const Ray posed = pose.posed(from_outside);
        if (cap_.sees(posed) &&
            std::abs(first_meeting(*pose.scene, posed, sampler) - distance - kOutside) <= kMaxDepthError)
            seen[count++] = &pose;
    }
    const float chance = sampler.next_1d();
    const auto drawn = [&](size_t of) {
        return std::min(static_cast<size_t>(chance * static_cast<float>(of)), of - 1);
    };
    return count != 0 ? *seen[drawn(count)] : part.poses[drawn(part.poses.size())];
}

// Begins just before the part: what stands farther off hides it in this pose, and may not in another.
std::optional<SampleTracer::PartLine> SampleTracer::line_to_part(const Ray& ray, const PartTracer& part,
                                                                 Sampler& sampler) const
{
    constexpr float kBefore = 2 * kMaxDepthError;
    std::optional<Hit> hit = part.mesh.closest(ray);
    if (!hit) return std::nullopt;
    const LitPose& pose = pose_along(ray, hit->distance, part, sampler);
    if (!cap_.sees(pose.posed(ray))) return std::nullopt;
    const float start = std::max(0.0f, hit->distance - kBefore);
    const Ray near = {ray.origin + ray.direction * start, ray.direction}, posed = pose.posed(near);
    hit->distance -= start;
    hit->triangle = part.numbers[hit->triangle];
    const bool is_there = std::abs(first_meeting(*pose.scene, posed, sampler) - hit->distance) <= kMaxDepthError;
    return is_there ? std::optional<PartLine>({{near, *hit, grey(1)}, posed, &pose}) : std::nullopt;
}

uint32_t SampleTracer::texel_of(const Hit& hit) const
{
    return texel_at(shape_.layout.rectangles[hit.triangle / 2], hit.triangle % 2 != 0, hit.u, hit.v);
}

bool SampleTracer::scene_is_there(const Line& line, Sampler sampler) const
{
    return std::abs(first_meeting(scene_, line.ray, sampler) - line.hit.distance) <= kMaxDepthError;
}

FitSample SampleTracer::sample(const Line& line, const Ray& seen, const PathResult& path) const
{
    const Vec3 eye = eye_of(seen);
    return {line.hit.triangle,
            texel_of(line.hit),
            q12(line.hit.u),
            q12(line.hit.v),
            {q12(eye.x), q12(eye.y), q12(eye.z)},
            before_panes(path.radiance, line.panes),
            before_panes(path.matt, line.panes)};
}

std::optional<FitSample> SampleTracer::sample_of_body(const Ray& ray, uint32_t patch, Sampler& sampler) const
{
    const std::optional<Line> l = cap_.sees(ray) ? line(ray, sampler) : std::nullopt;
    if (!l || l->hit.triangle / 2 != patch) return std::nullopt;
    const PathResult path = tracer_.trace(l->ray, sampler);
    return path.covered ? std::optional<FitSample>(sample(*l, l->ray, path)) : std::nullopt;
}

std::optional<FitSample> SampleTracer::sample_of_part(const Ray& ray, uint32_t patch, const PartTracer& part,
                                                      Sampler& sampler) const
{
    const std::optional<PartLine> l = line_to_part(ray, part, sampler);
    if (!l || l->own.hit.triangle / 2 != patch) return std::nullopt;
    const PathResult path = PathTracer(*l->pose->scene).trace(l->posed, sampler);
    if (!path.covered) return std::nullopt;
    return sample(l->own, part.light_stays ? l->posed : l->own.ray, path);
}

void SampleTracer::trace(uint64_t seed, uint32_t patch, uint32_t texel, uint32_t lines,
                         std::vector<FitSample>& samples) const
{
    Sampler sampler(seed, patch, 0);
    const uint32_t owner = shape_.mesh.owner_of(patch);
    for (uint32_t k = 0; k < lines; ++k) {
        sampler.start(texel * lines + k);
        const std::optional<Ray> ray = texel_line(shape_, patch, texel, sampler);
        if (!ray) continue;
        const std::optional<FitSample> sample = owner == 0 ? sample_of_body(*ray, patch, sampler)
                                                           : sample_of_part(*ray, patch, *parts_[owner - 1], sampler);
        if (sample) samples.push_back(*sample);
    }
}

std::vector<PassingSample> SampleTracer::passing(uint64_t seed, uint32_t batch) const
{
    std::vector<PassingSample> result;
    Sampler sampler(seed, batch, 0);
    for (uint32_t k = 0; k < kLines; ++k) {
        sampler.start(k);
        const std::optional<Ray> r = ray(sampler);
        if (!r) continue;
        Sampler ahead = sampler;
        std::vector<Hit> passed;
        const std::optional<Hit> hit = closest_opaque(scene_, *r, ahead, passed);
        const size_t first = result.size();
        Rgb coloured = grey(1);  // what the panes so far make of light that is 1 behind them
        const auto add = [&](const Hit& in_scene, bool passes) {
            if (!is_see_through(in_scene)) return;
            if (const std::optional<Line> l = line_to(*r, in_scene))
                result.push_back({texel_of(l->hit), opacity_of(scene_, in_scene),
                                  passing_light(scene_, in_scene, r->direction), passes, false, coloured});
        };
        for (const Hit& surface : passed) {
            coloured = coloured * colour_of_pass(scene_, surface, r->direction);
            add(surface, true);
        }
        if (hit) add(*hit, false);
        if (first == result.size() || !result[first].passes) continue;
        const PathResult path = tracer_.trace(*r, sampler);
        for (size_t s = first; s < result.size(); ++s) {
            if (!result[s].passes) continue;
            result[s].covered = path.covered;
            result[s].radiance = before_panes(path.radiance, result[s].radiance);
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
