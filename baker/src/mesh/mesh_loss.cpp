// SPDX-License-Identifier: MIT
#include "mesh/mesh_loss.h"

#include <cmath>

#include "math/frame.h"

namespace lumi::baker
{
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
    if (loss.rough) {
        warn("the scene could only be simplified roughly, since its surfaces are torn or run through each other",
             "weld its vertices or give neighbouring faces one winding");
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
