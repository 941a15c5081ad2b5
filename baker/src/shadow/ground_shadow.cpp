// SPDX-License-Identifier: MIT
#include "shadow/ground_shadow.h"

#include <algorithm>
#include <cmath>

#include "fit/fit_shape.h"
#include "math/warp.h"
#include "scene/moving_parts.h"
#include "scene/placement.h"
#include "shadow/taken_light.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kGroundSeed = 0x67726F756E64;
constexpr float kGap = 1e-3f;           // radii below the lowest point: paths begin between both
constexpr float kGroundAlbedo = 0.5f;   // between those of dark and bright tables
constexpr uint32_t kGroundPaths = 128;  // to a texel, with the object and without
constexpr float kFade = 0.35f;          // radii from the disc's rim in which the shadow fades out; at most all of it
constexpr float kTouching = 0.03f;      // radii: what lies so low hides the ground
constexpr float kSmallestDisc = 0.1f;   // radii
constexpr float kDiscInside = 0.998f;   // share of the disc that is used: vertices are rounded
constexpr float kUnseenShade = 0.015f;  // a share of light that no one misses

// The object on its ground, or that ground alone; only what lies in the sphere sends light back to it.
std::unique_ptr<SceneData> on_ground(const SceneData& scene, float height, bool has_object)
{
    Material matt;
    matt.base = grey(kGroundAlbedo);
    matt.finish();
    SceneParts parts;
    parts.mesh = part_of(scene.mesh, [&](size_t) { return has_object; });
    parts.materials = scene.materials;
    append_disc(parts, {{0, 0, height}, std::sqrt(1 - height * height)}, UpAxis::z, matt);
    return with_mesh(scene, std::move(parts.mesh), {matt});
}

float lowest_of(const SceneData& scene)
{
    float lowest = 1;
    for (size_t t = 0; t < scene.mesh.triangle_count(); ++t)
        for (size_t k = 0; k < 3; ++k) lowest = std::min(lowest, scene.mesh.position(t, k).z);
    return lowest;
}

// Texels of all pieces as rows of one picture.
struct GroundPicture {
    uint32_t side;
    std::vector<float> values;
    std::vector<uint8_t> is_hidden;  // right below the object, where nobody looks

    // Takes out the noise of neighbours: weights 1, 2, 1 along one axis. Hidden texels do not count, or they would
    // darken what is seen beside the rim; those at the rim become as their neighbours.
    void smooth(bool along_rows)
    {
        const GroundPicture before = *this;
        for (uint32_t k = 0; k < side * side; ++k) {
            const uint32_t step = along_rows ? 1 : side, at = along_rows ? k % side : k / side;
            float sum = 0, weight = 0;
            const auto add = [&](uint32_t from, float w) {
                if (before.is_hidden[from] != 0) return;
                sum += w * before.values[from];
                weight += w;
            };
            add(k, 2);
            if (at != 0) add(k - step, 1);
            if (at + 1 != side) add(k + step, 1);
            if (weight == 0) continue;
            values[k] = sum / weight;
            is_hidden[k] = 0;
        }
    }
};

class GroundTracer
{
public:
    GroundTracer(const SceneData& scene, const GroundShadow& shadow, uint64_t seed)
        : object_(on_ground(scene, shadow.height - kGap, true)),
          ground_(on_ground(scene, shadow.height - kGap, false)),
          with_(*object_),
          without_(*ground_),
          shadow_(shadow),
          seed_(seed),
          taken_{shadow.pieces * shadow.side, std::vector<float>(shadow.passed.size()),
                 std::vector<uint8_t>(shadow.passed.size())},
          light_(shadow.passed.size())
    {
    }

    void trace(Job& job)
    {
        job.run(taken_.side, [&](uint32_t y) {
            for (uint32_t x = 0; x < taken_.side; ++x) measure(x, y);
        });
        for (const bool along_rows : {true, false, true, false}) taken_.smooth(along_rows);
    }

    float mean_light() const
    {
        double sum = 0;
        for (const float light : light_) sum += static_cast<double>(light);
        return static_cast<float>(sum / static_cast<double>(light_.size()));
    }

    // The share of light that is missing; it fades out where the sphere ends.
    float taken(uint32_t x, uint32_t y)
    {
        const Vec3 p = shadow_.place(x, y);
        const float to_rim = shadow_.radius - std::sqrt(p.x * p.x + p.y * p.y);
        const float t = std::clamp(to_rim / std::min(kFade, shadow_.radius), 0.0f, 1.0f);
        const float share = taken_.values[y * taken_.side + x] * t * t * (3 - 2 * t);
        return share < kUnseenShade ? 0 : share;
    }

private:
    void measure(uint32_t x, uint32_t y)
    {
        const Ray ray = {shadow_.place(x, y) - Vec3{0, 0, 0.5f * kGap}, {0, 0, -1}};
        const uint32_t k = y * taken_.side + x;
        const TakenLight light = taken_light(ray, with_, without_, {kGroundPaths, seed_ + kGroundSeed, k});
        const std::optional<Hit> above = object_->accelerator.closest({ray.origin, {0, 0, 1}});
        taken_.is_hidden[k] = above && above->distance < kTouching ? 1 : 0;
        light_[k] = light.without;
        taken_.values[k] = light.taken;
    }

    const std::unique_ptr<SceneData> object_, ground_;
    const PathTracer with_, without_;
    const GroundShadow& shadow_;
    const uint64_t seed_;
    GroundPicture taken_;
    std::vector<float> light_;
};

}  // namespace

Vec3 GroundShadow::corner(uint32_t x, uint32_t y) const
{
    constexpr float kSteps = 1 << 14;  // of the format
    const auto along = [&](uint32_t k) { return static_cast<float>(k) / static_cast<float>(pieces); };
    const Vec2 p = square_to_disc({along(x), along(y)});
    const auto rounded = [](float c) { return std::round(c * kSteps) / kSteps; };
    return {rounded(radius * p.x), rounded(radius * p.y), rounded(height)};
}

Vec3 GroundShadow::place(uint32_t x, uint32_t y) const
{
    const uint32_t left = x / side, top = y / side;
    const Vec2 w = place_in({0, side, side}, y % side * side + x % side, {0.5f, 0.5f});
    const Vec3 b = corner(left + 1, top), c = corner(left, top + 1);
    if (w.x + w.y <= 1) {
        const Vec3 a = corner(left, top);
        return a + (b - a) * w.x + (c - a) * w.y;
    }
    const Vec3 d = corner(left + 1, top + 1);
    return d + (c - d) * (1 - w.x) + (b - d) * (1 - w.y);
}

size_t GroundShadow::texel(uint32_t x, uint32_t y) const
{
    const size_t piece = size_t{y / side} * pieces + x / side;
    return piece * side * side + size_t{y % side} * side + x % side;
}

GroundGrid ground_grid(float longest_edge, float texels_per_radius)
{
    constexpr float kLongestOfUnit = 2.6f;  // of a piece's edges and its diagonal, if one piece were the disc
    constexpr float kFewest = 4, kMost = 12, kDensity = 1, kFewestTexels = 16, kMostTexels = 80;
    const float pieces = std::clamp(std::ceil(kLongestOfUnit / longest_edge), kFewest, kMost);
    const float texels = std::clamp(kDensity * texels_per_radius, kFewestTexels, kMostTexels);
    return {static_cast<uint32_t>(pieces), static_cast<uint32_t>(std::ceil(texels / pieces))};
}

GroundShadow ground_shadow(const SceneData& scene, const PatchMesh& mesh, const SurfaceSettings& settings,
                           const ProgressCallback& progress)
{
    GroundShadow shadow;
    if (!settings.ground) return shadow;
    shadow.height = lowest_of(scene);
    shadow.radius = kDiscInside * std::sqrt(std::max(0.0f, 1 - shadow.height * shadow.height));
    if (shadow.radius < kSmallestDisc) {
        shadow.notes.emplace_back("the ground has no shadow: the object's lowest point leaves no room in its sphere");
        return shadow;
    }
    const GroundGrid grid = ground_grid(mesh.longest_edge, settings.texels_per_radius);
    shadow.pieces = grid.pieces;
    shadow.side = grid.side;
    const uint32_t side = grid.pieces * grid.side;
    shadow.passed.resize(size_t{side} * side);
    GroundTracer tracer(scene, shadow, settings.seed);
    Job job(uint64_t{2} * kGroundPaths * side * side, settings.threads, progress);
    const JobStage stage(job, Stage::mesh, job.part_of_rest(1), 1);
    tracer.trace(job);
    const EncodedTone tone(scene.tone);
    const float light = tracer.mean_light();
    if (!(light > 0)) {
        shadow.notes.emplace_back("the ground has no shadow: no light reaches it");
        shadow.passed.clear();
        return shadow;
    }
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x)
            shadow.passed[shadow.texel(x, y)] = passed_share(tone, light, 1 - tracer.taken(x, y));
    return shadow;
}

}  // namespace lumi::baker
