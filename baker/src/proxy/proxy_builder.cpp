// SPDX-License-Identifier: MIT
#include "proxy/proxy_builder.h"

#include <map>

#include "lumi/guided/guided_format.h"
#include "proxy/proxy_fit.h"
#include "proxy/proxy_loss.h"
#include "proxy/proxy_outside.h"
#include "proxy/proxy_seen.h"
#include "proxy/proxy_simplify.h"

namespace lumi::baker
{
namespace
{

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
    result.loss = loss_of(scene, ProxyTracer(unpacked(result.proxy), outside.two_sided), job);
    return result;
}

}  // namespace lumi::baker
