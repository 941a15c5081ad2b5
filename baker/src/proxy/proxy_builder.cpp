// SPDX-License-Identifier: MIT
#include "proxy/proxy_builder.h"

#include <map>

#include "lumi/guided/guided_format.h"
#include "proxy/proxy_fit.h"
#include "proxy/proxy_outside.h"
#include "proxy/proxy_simplify.h"

namespace lumi::baker
{
namespace
{

constexpr int kFittingRounds = 4;
constexpr uint32_t kSurveyOrigins = 192;
constexpr uint32_t kRaysPerTriangle = 200;  // of all origins together
constexpr uint32_t kMaxRaysPerOrigin = 8192;
constexpr uint32_t kLossRays = 2048;  // an origin
constexpr uint64_t kFitSeed = 0x70726F78, kLossSeed = 0x6C6F7373;

ProxyLoss loss_of(const SceneData& scene, const PackedProxy& proxy, Job& job)
{
    const ProxyTracer tracer(unpacked(proxy), proxy.two_sided);
    const Survey survey(scene, kSurveyOrigins, kLossRays, kLossSeed);
    struct Counts {
        uint32_t scene = 0, missed = 0, added = 0, displaced = 0;
    };
    std::vector<Counts> counts(survey.origins());
    job.run(survey.origins(), [&](uint32_t i) {
        for (const SurveyRay& r : survey.look(i, tracer)) {
            const bool hit = std::isfinite(r.scene);
            counts[i].scene += hit ? 1u : 0u;
            counts[i].missed += hit && !r.proxy ? 1u : 0u;
            counts[i].added += !hit && r.proxy ? 1u : 0u;
            const bool displaced = hit && r.proxy && std::abs(r.scene - r.proxy->distance) > kMaxDepthError;
            counts[i].displaced += displaced ? 1u : 0u;
        }
    });
    Counts sum;
    for (const Counts& c : counts) {
        sum = {sum.scene + c.scene, sum.missed + c.missed, sum.added + c.added, sum.displaced + c.displaced};
    }
    const double hits = std::max(1u, sum.scene);
    return {sum.missed / hits, sum.added / hits, sum.displaced / hits};
}

uint32_t rays_per_origin(const Mesh& mesh)
{
    const uint32_t rays = static_cast<uint32_t>(mesh.triangle_count()) * kRaysPerTriangle / kSurveyOrigins + 1;
    return std::min(rays, kMaxRaysPerOrigin);
}

Mesh fitted_in_rounds(const SceneData& scene, Mesh mesh, bool two_sided, Job& job)
{
    const Survey survey(scene, kSurveyOrigins, rays_per_origin(mesh), kFitSeed);
    for (int round = 0; round < kFittingRounds && mesh.triangle_count() != 0; ++round) {
        mesh = fitted(mesh, two_sided, survey, job);
    }
    return mesh;
}

// Without the triangles that no ray from around sees.
Mesh seen_part(const SceneData& scene, const Mesh& mesh, bool two_sided, Job& job)
{
    const ProxyTracer tracer(mesh, two_sided);
    const Survey survey(scene, kSurveyOrigins, rays_per_origin(mesh), kFitSeed);
    std::vector<std::vector<uint8_t>> seen(survey.origins(), std::vector<uint8_t>(mesh.triangle_count(), 0));
    job.run(survey.origins(), [&](uint32_t i) {
        for (const SurveyRay& r : survey.look(i, tracer)) {
            if (r.proxy) {
                seen[i][r.proxy->triangle] = 1;
            }
        }
    });
    Mesh result;
    result.positions = mesh.positions;
    for (size_t k = 0; k < mesh.triangle_count(); ++k) {
        if (std::any_of(seen.begin(), seen.end(), [k](const std::vector<uint8_t>& part) { return part[k] != 0; })) {
            result.corners.push_back(mesh.corners[k]);
        }
    }
    return result;
}

PackedProxy::Triple packed(const Vec3& p)
{
    const auto coordinate = [](float c) {
        return static_cast<uint16_t>(std::clamp(std::lround(c * 2048) + 2048, 0L, 4095L));
    };
    return {coordinate(p.x), coordinate(p.y), coordinate(p.z)};
}

bool has_area(const Mesh& mesh, size_t triangle)
{
    return length(mesh.area_vector(triangle)) > 0;
}

}  // namespace

PackedProxy packed(const Mesh& mesh, bool two_sided)
{
    PackedProxy all, used;
    std::map<PackedProxy::Triple, uint16_t> numbers;
    std::vector<uint16_t> merged;
    for (const Vec3& p : mesh.positions) {
        const PackedProxy::Triple v = packed(p);
        const auto [found, added] = numbers.emplace(v, static_cast<uint16_t>(all.vertices.size()));
        if (added) {
            all.vertices.push_back(v);
        }
        merged.push_back(found->second);
    }
    for (const Mesh::Corners& c : mesh.corners) {
        all.triangles.push_back({merged[c[0]], merged[c[1]], merged[c[2]]});
    }
    const Mesh rounded = unpacked(all);
    std::vector<int> number(all.vertices.size(), -1);
    const auto corner = [&](uint16_t old) {
        if (number[old] < 0) {
            number[old] = static_cast<int>(used.vertices.size());
            used.vertices.push_back(all.vertices[old]);
        }
        return static_cast<uint16_t>(number[old]);
    };
    for (size_t k = 0; k < all.triangles.size(); ++k) {
        if (has_area(rounded, k)) {
            const PackedProxy::Triple& t = all.triangles[k];
            used.triangles.push_back({corner(t[0]), corner(t[1]), corner(t[2])});
        }
    }
    used.two_sided = two_sided;
    return used;
}

BuiltProxy build_proxy(const SceneData& scene, uint32_t triangles, Job& job)
{
    const Outside outside = outside_of(scene, job);
    Mesh mesh = simplified(outside.mesh, triangles);
    // Open meshes can have more vertices than triangles.
    for (uint32_t fewer = triangles;
         mesh.positions.size() > format::kMaxProxyVertices || mesh.triangle_count() > format::kMaxProxyTriangles;) {
        fewer = fewer * 4 / 5;
        mesh = simplified(mesh, fewer);
    }
    mesh = fitted_in_rounds(scene, std::move(mesh), outside.two_sided, job);
    mesh = seen_part(scene, mesh, outside.two_sided, job);
    BuiltProxy result = {packed(mesh, outside.two_sided), {}};
    result.loss = loss_of(scene, result.proxy, job);
    return result;
}

}  // namespace lumi::baker
