// SPDX-License-Identifier: MIT
#include "model/facets.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "geometry/polygon.h"
#include "geometry/smooth_groups.h"
#include "lumi/baker/scene.h"
#include "model/vertices.h"

namespace lumi::baker
{
namespace
{

constexpr float kCreaseCosine = 0.8660254f;  // 30 degrees
constexpr Mesh::OptionalCorners kNone = {kNoIndex, kNoIndex, kNoIndex};

struct PointHash {
    size_t operator()(const Point& p) const
    {
        size_t hash = 0;
        for (const double c : p) hash = hash * 0x9E3779B97F4A7C15 + std::hash<double>()(c);
        return hash;
    }
};

// For each position, the first one at the same place.
std::vector<uint32_t> first_at_each_place(const std::vector<Point>& positions)
{
    std::unordered_map<Point, uint32_t, PointHash> places;
    places.reserve(positions.size());
    std::vector<uint32_t> result;
    result.reserve(positions.size());
    for (uint32_t k = 0; k < positions.size(); ++k) result.push_back(places.try_emplace(positions[k], k).first->second);
    return result;
}

// Products of three lengths have to stay within binary32.
float power_of_two_near(const std::vector<Vec3>& positions)
{
    float largest = 0;
    for (const Vec3& p : positions) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return largest > 0 ? std::ldexp(1.0f, std::ilogb(largest)) : 1;
}

void smooth(Mesh& mesh)
{
    const float scale = power_of_two_near(mesh.positions);
    for (Vec3& p : mesh.positions) p = p * (1 / scale);
    Mesh creased = with_creases(mesh, kCreaseCosine);
    for (Vec3& p : creased.positions) p = p * scale;
    mesh.positions = std::move(creased.positions);
    mesh.normals = std::move(creased.normals);
    mesh.corners = std::move(creased.corners);
    for (size_t k = 0; k < mesh.triangle_count(); ++k)
        for (size_t i = 0; i < 3; ++i) mesh.shading[k][i] = static_cast<int32_t>(mesh.corners[k][i]);
}

Vec3 unit_or_none(const Vec3& n)
{
    const float size = length(n);
    return size > 0 && std::isfinite(size) ? n / size : Vec3{};
}

class FacetMesh
{
public:
    FacetMesh(const Facets& facets, SceneParts& parts) : facets_(facets), mesh_(parts.mesh)
    {
        CentredPositions at = centred(facets.positions);
        parts.origin = at.origin;
        mesh_.positions = std::move(at.positions);
        for (const Vec3& n : facets.normals) mesh_.normals.push_back(unit_or_none(n));
    }

    // The triangles that it keeps.
    std::vector<Mesh::Corners> build(Losses& losses)
    {
        std::vector<Mesh::Corners> kept;
        for (const Mesh::Corners& t : facets_.triangles)
            if (!has_no_area(mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]])) kept.push_back(t);
        losses.add("triangle(s) have no area and are left out; merge doubled vertices",
                   facets_.triangles.size() - kept.size());
        const bool shaded = !facets_.normals.empty();
        const std::vector<uint32_t> first = shaded ? std::vector<uint32_t>() : first_at_each_place(facets_.positions);
        for (const Mesh::Corners& t : kept) {
            mesh_.corners.push_back(shaded ? t : Mesh::Corners{first[t[0]], first[t[1]], first[t[2]]});
            mesh_.shading.push_back(shaded
                                        ? Mesh::OptionalCorners{static_cast<int32_t>(t[0]), static_cast<int32_t>(t[1]),
                                                                static_cast<int32_t>(t[2])}
                                        : kNone);
        }
        mesh_.mapping.assign(kept.size(), kNone);
        mesh_.materials.assign(kept.size(), 0);
        if (!shaded && !kept.empty()) smooth(mesh_);
        return kept;
    }

private:
    const Facets& facets_;
    Mesh& mesh_;
};

}  // namespace

SceneParts parts_of_facets(const std::filesystem::path& file, Facets facets, Losses& losses)
{
    SceneParts parts;
    const std::vector<Mesh::Corners> kept = FacetMesh(facets, parts).build(losses);
    if (kept.empty()) throw SceneError(at({file.string()}, "no face has an area; check the scale and the vertices"));
    Material material;
    material.name = file.stem().string();
    if (!facets.colours.empty()) {
        std::vector<CornerColours> corners;
        for (const Mesh::Corners& t : kept)
            corners.push_back({facets.colours[t[0]], facets.colours[t[1]], facets.colours[t[2]]});
        material.base = grey(1);
        material.maps.base.texture = 0;
        parts.textures.push_back(picture_of_corners(parts.mesh, 0, corners));
    }
    material.finish();
    parts.materials.push_back(std::move(material));
    return parts;
}

}  // namespace lumi::baker
