// SPDX-License-Identifier: MIT
// Rays from all around the sphere, spread as a chart's are: what meshes are fitted with and judged by.
#pragma once

#include "geometry/view_cap.h"
#include "mesh/mesh_tracer.h"
#include "scene/scene_data.h"
#include "util/job.h"

namespace lumi::baker
{

// Two depths that differ by at most so much belong to the same surface; in radii.
inline constexpr float kMaxDepthError = 0.05f;

// The hits of one ray; distances along it, infinite for a miss.
struct SurveyRay {
    Ray ray;
    float scene;
    std::optional<Hit> mesh;
};

class Survey
{
public:
    // Keeps those rays along which eyes of the cap see.
    Survey(const SceneData& scene, uint32_t origins, uint32_t rays_per_origin, uint64_t seed, const ViewCap& cap = {});

    const SceneData& scene() const { return scene_; }
    const ViewCap& cap() const { return cap_; }
    uint32_t origins() const { return origins_; }
    // Sends the same rays every time. Thread-safe.
    std::vector<SurveyRay> look(uint32_t origin, const MeshTracer& tracer) const;

private:
    const SceneData& scene_;
    uint32_t origins_, rays_;
    uint64_t seed_;
    ViewCap cap_;
};

// As many origins as measures of whole meshes take.
inline constexpr uint32_t kSurveyOrigins = 192;

// Enough rays for each triangle of `mesh`.
Survey fitting_survey(const SceneData& scene, const Mesh& mesh, const ViewCap& cap = {});

}  // namespace lumi::baker
