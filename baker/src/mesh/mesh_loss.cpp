// SPDX-License-Identifier: MIT
#include "mesh/mesh_loss.h"

namespace lumi::baker
{
namespace
{

constexpr uint32_t kLossRays = 2048;  // an origin
constexpr uint64_t kLossSeed = 0x6C6F7373;

}  // namespace

MeshLoss loss_of(const SceneData& scene, const MeshTracer& tracer, Job& job, const ViewCap& cap)
{
    const Survey survey(scene, kSurveyOrigins, kLossRays, kLossSeed, cap);
    struct Counts {
        uint32_t scene = 0, missed = 0, added = 0, displaced = 0;
    };
    std::vector<Counts> counts(survey.origins());
    job.run(survey.origins(), [&](uint32_t i) {
        for (const SurveyRay& r : survey.look(i, tracer)) {
            const bool hit = std::isfinite(r.scene);
            counts[i].scene += hit ? 1u : 0u;
            counts[i].added += !hit && r.mesh ? 1u : 0u;
            const bool displaced = hit && r.mesh && std::abs(r.scene - r.mesh->distance) > kMaxDepthError;
            // A path that the volume stops far from the mesh misses it.
            const bool lost = hit && (!r.mesh || (displaced && scene.medium));
            counts[i].missed += lost ? 1u : 0u;
            counts[i].displaced += displaced && !lost ? 1u : 0u;
        }
    });
    Counts sum;
    for (const Counts& c : counts)
        sum = {sum.scene + c.scene, sum.missed + c.missed, sum.added + c.added, sum.displaced + c.displaced};
    const double hits = std::max(1u, sum.scene);
    MeshLoss loss;
    loss.missed = sum.missed / hits;
    loss.added = sum.added / hits;
    loss.displaced = sum.displaced / hits;
    return loss;
}

}  // namespace lumi::baker
