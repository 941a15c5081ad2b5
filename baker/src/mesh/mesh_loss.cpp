// SPDX-License-Identifier: MIT
#include "mesh/mesh_loss.h"

#include <cmath>

#include "math/vec3.h"
#include "math/warp.h"
#include "trace/hit_point.h"

namespace lumi::baker
{

namespace
{

constexpr int kSide = static_cast<int>(kSilhouetteSize);
constexpr float kGoldenRatio = 0.618034f;
constexpr float kRayStart = 2;  // where rays start, in radii

class Mask
{
public:
    Mask() : pixels_(kSilhouetteSize * kSilhouetteSize, false) {}

    bool at(int x, int y) const { return x >= 0 && y >= 0 && x < kSide && y < kSide && pixels_[index(x, y)]; }
    void set(int x, int y, bool value) { pixels_[index(x, y)] = value; }
    uint32_t count() const { return static_cast<uint32_t>(std::count(pixels_.begin(), pixels_.end(), true)); }

    // How many of the w × h pixels from (x, y) on are set.
    uint32_t count(int x, int y, int w, int h) const
    {
        uint32_t sum = 0;
        for (int k = 0; k < w * h; ++k) sum += at(x + k % w, y + k / w) ? 1u : 0u;
        return sum;
    }

    // Clears the connected region around a pixel and returns its size.
    uint32_t clear_region(int x, int y)
    {
        std::vector<std::array<int, 2>> open = {{x, y}};
        uint32_t size = 0;
        while (!open.empty()) {
            const auto [px, py] = open.back();
            open.pop_back();
            if (!at(px, py)) continue;
            set(px, py, false);
            ++size;
            for (int k = 0; k < 9; ++k) open.push_back({px - 1 + k % 3, py - 1 + k / 3});
        }
        return size;
    }

private:
    static size_t index(int x, int y) { return static_cast<size_t>(y * kSide + x); }

    std::vector<bool> pixels_;
};

float height_of(uint32_t direction)
{
    return (2 * static_cast<float>(direction) + 1) / kSilhouettes - 1;
}

template <class Covers>
Mask silhouette(uint32_t direction, const Covers& covers)
{
    const Frame frame(direction_at(height_of(direction), kGoldenRatio * static_cast<float>(direction)));
    Mask mask;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const auto place = [](int k) { return (2 * static_cast<float>(k) + 1) / kSide - 1; };
            mask.set(x, y, covers(Ray{frame.to_world({place(x), place(y), kRayStart}), -frame.normal}));
        }
    }
    return mask;
}

bool is_two_thick(const Mask& mask, int x, int y)
{
    return mask.count(x, y, 2, 2) == 4 || mask.count(x - 1, y, 2, 2) == 4 || mask.count(x, y - 1, 2, 2) == 4 ||
           mask.count(x - 1, y - 1, 2, 2) == 4;
}

Mask missing_of(const Mask& scene, const Mask& mesh)
{
    Mask result;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const bool inside = scene.count(x - 1, y - 1, 3, 3) == 9;
            const bool gone = mesh.count(x - 1, y - 1, 3, 3) == 0 && is_two_thick(scene, x, y);
            result.set(x, y, scene.at(x, y) && !mesh.at(x, y) && (inside || gone));
        }
    }
    return result;
}

bool covers(const SceneData& scene, const Ray& ray)
{
    return scene.has_transparency ? max_component(transmittance(scene, ray)) < 0.5f : scene.accelerator.blocked(ray);
}

MissingPixels missing_from(uint32_t direction, const SceneData& scene, const MeshTracer& mesh)
{
    const Mask truth = silhouette(
        direction, [&](const Ray& ray) { return covers(scene, ray); });
    const Mask drawn = silhouette(direction, [&](const Ray& ray) { return mesh.closest(ray).has_value(); });
    Mask missing = missing_of(truth, drawn);
    MissingPixels result = {truth.count(), missing.count()};
    for (int k = 0; k < kSide * kSide; ++k) {
        const uint32_t region = missing.clear_region(k % kSide, k / kSide);
        result.largest = std::max(result.largest, region);
        result.regions += region > kMaxMissing ? 1u : 0u;
    }
    return result;
}

}  // namespace

MissingPixels missing_pixels(const SceneData& scene, const MeshTracer& mesh, Job& job, const ViewCap& cap)
{
    std::vector<MissingPixels> parts(kSilhouettes);
    job.run(kSilhouettes, [&](uint32_t d) {
        if (height_of(d) >= cap.lowest()) parts[d] = missing_from(d, scene, mesh);
    });
    MissingPixels sum;
    for (const MissingPixels& part : parts) {
        sum = {sum.scene + part.scene, sum.missing + part.missing, std::max(sum.largest, part.largest),
               sum.regions + part.regions};
    }
    return sum;
}

namespace
{

constexpr uint32_t kLossRays = 2048;  // an origin
constexpr uint64_t kLossSeed = 0x6C6F7373;

constexpr float kPixel = 1.0f / 120;    // at 240 x 240, in radii
constexpr uint32_t kThinnessEvery = 4;  // rays: the others are not asked

constexpr double kMaxMissed = 0.01, kMaxThin = 0.001;
constexpr double kFarShort = 0.6;  // as a share of the triangles asked for

std::string percent(double share)
{
    const long tenths = std::lround(share * 1000);
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " %";
}

// Whether something that a ray meets ends within half a pixel on two opposite sides.
bool is_thin(const SceneData& scene, const SurveyRay& seen)
{
    constexpr int kAngles = 4;
    const Frame frame(seen.ray.direction);
    const auto ends = [&](float angle) {
        const Vec3 aside = frame.tangent * std::cos(angle) + frame.bitangent * std::sin(angle);
        const Ray beside = {seen.ray.origin + aside * (0.5f * kPixel), seen.ray.direction, seen.scene + kMaxDepthError};
        return !scene.accelerator.blocked(beside);
    };
    for (int k = 0; k < kAngles; ++k) {
        const float angle = kPi * static_cast<float>(k) / kAngles;
        if (ends(angle) && ends(angle + kPi)) return true;
    }
    return false;
}

}  // namespace

MeshLoss loss_of(const SceneData& scene, const MeshTracer& tracer, Job& job, const ViewCap& cap,
                 const MeshTracer* see_through)
{
    const Survey survey(scene, kSurveyOrigins, kLossRays, kLossSeed, cap);
    const bool is_solid = !scene.has_transparency && !scene.medium;
    struct Counts {
        uint32_t scene = 0, missed = 0, added = 0, displaced = 0, asked = 0, thin = 0;
    };
    std::vector<Counts> counts(survey.origins());
    job.run(survey.origins(), [&](uint32_t i) {
        uint32_t number = 0;
        for (const SurveyRay& r : survey.look(i, tracer)) {
            const bool hit = std::isfinite(r.scene);
            if (hit && is_solid && number++ % kThinnessEvery == 0) {
                ++counts[i].asked;
                counts[i].thin += is_thin(scene, r) ? 1u : 0u;
            }
            counts[i].scene += hit ? 1u : 0u;
            counts[i].added += !hit && r.mesh ? 1u : 0u;
            if (hit && see_through && see_through->near(r.ray, r.scene, kMaxDepthError)) continue;
            const bool displaced = hit && r.mesh && std::abs(r.scene - r.mesh->distance) > kMaxDepthError;
            // A path that the volume stops far from the mesh misses it.
            const bool lost = hit && (!r.mesh || (displaced && scene.medium));
            counts[i].missed += lost ? 1u : 0u;
            counts[i].displaced += displaced && !lost ? 1u : 0u;
        }
    });
    Counts sum;
    for (const Counts& c : counts)
        sum = {sum.scene + c.scene,         sum.missed + c.missed, sum.added + c.added,
               sum.displaced + c.displaced, sum.asked + c.asked,   sum.thin + c.thin};
    const double hits = std::max(1u, sum.scene);
    MeshLoss loss;
    loss.missed = sum.missed / hits;
    loss.added = sum.added / hits;
    loss.displaced = sum.displaced / hits;
    loss.thin = sum.thin / std::max(1.0, static_cast<double>(sum.asked));
    return loss;
}

std::vector<MeshWarning> mesh_warnings(const MeshLoss& loss, const MeshCount& triangles, bool of_volume)
{
    std::vector<MeshWarning> warnings;
    const auto warn = [&](std::string problem, const char* remedy = "") {
        warnings.push_back({std::move(problem), remedy, !triangles.all});
    };
    const std::string misses = "the mesh misses " + percent(loss.missed) + " of what can be seen";
    if (loss.missed > kMaxMissed && of_volume) {
        warnings.push_back({misses + ", which is soft or half transparent",
                            "take a chord field, which shows that, but blurs the rest", false});
    } else if (loss.missed > kMaxMissed) {
        warn(misses, "thicken parts that are thinner than a pixel");
    }
    if (loss.thin > kMaxThin) {
        warnings.push_back(
            {percent(loss.thin) + " of what can be seen is thinner than a pixel at 240 x 240, so samples may miss it",
             "thicken it, or draw it larger", false});
    }
    if (static_cast<double>(triangles.got) < kFarShort * static_cast<double>(triangles.asked)) {
        warn("the mesh has " + std::to_string(triangles.got) + " triangles where " + std::to_string(triangles.asked) +
             " were asked for, since the shape cannot be simplified to that number");
    }
    if (loss.holes > 0) {
        warn("the mesh has " + std::to_string(loss.holes) +
             (loss.holes == 1 ? " hole of " : " holes, the largest of ") + std::to_string(loss.largest_hole) +
             " pixels at 240 x 240");
    }
    return warnings;
}

}  // namespace lumi::baker
