// SPDX-License-Identifier: MIT
#include "mesh/survey.h"

#include "lumi/detail/lattice.h"
#include "math/vec3.h"
#include "math/warp.h"
#include "trace/hit_point.h"

namespace lumi::baker
{
namespace
{

constexpr uint32_t kRaysPerTriangle = 200;  // from all origins together
constexpr uint32_t kMaxRaysPerOrigin = 8192;
constexpr uint64_t kFitSeed = 0x70726F78;

// Into the sphere from an origin; a place in the unit disc is the ray's direction, projected along the normal.
Ray inward_ray(const Frame& origin, const Vec2& place)
{
    const float inwards = std::sqrt(std::max(0.0f, 1 - place.x * place.x - place.y * place.y));
    return {origin.normal, normalized(origin.tangent * place.x + origin.bitangent * place.y - origin.normal * inwards)};
}

}  // namespace

Survey::Survey(const SceneData& scene, uint32_t origins, uint32_t rays_per_origin, uint64_t seed, const ViewCap& cap)
    : scene_(scene), origins_(origins), rays_(rays_per_origin), seed_(seed), cap_(cap)
{
}

std::vector<SurveyRay> Survey::look(uint32_t origin, const MeshTracer& tracer) const
{
    const Frame frame(unit_vector(detail::point(detail::Lattice(origins_), origin)));
    Sampler sampler(seed_, origin, 0);
    std::vector<SurveyRay> result;
    result.reserve(rays_);
    for (uint32_t k = 0; k < rays_; ++k) {
        sampler.start(k);
        const Ray ray = inward_ray(frame, square_to_disc(sampler.next_2d()));
        if (!cap_.sees(ray)) continue;
        const float distance = first_meeting(scene_, ray, sampler);
        result.push_back({ray, distance, tracer.closest(ray)});
    }
    return result;
}

Survey fitting_survey(const SceneData& scene, const Mesh& mesh, const ViewCap& cap)
{
    const uint32_t rays = static_cast<uint32_t>(mesh.triangle_count()) * kRaysPerTriangle / kSurveyOrigins + 1;
    return Survey(scene, kSurveyOrigins, std::min(rays, kMaxRaysPerOrigin), kFitSeed, cap);
}

}  // namespace lumi::baker
