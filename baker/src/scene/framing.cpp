// SPDX-License-Identifier: MIT
#include "scene/framing.h"

#include <algorithm>
#include <cmath>

#include "scene/named_triangles.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

constexpr double kMargin = 0.02;  // the sphere around the part grows by so much: the body's corners stick out by less
constexpr int kSides = 512;  // the body that is cut along has them; its corners lie within 0.02 of its inscribed sphere

BoundingSphere sphere_around(const std::vector<bool>& chosen, const Mesh& mesh)
{
    std::vector<Vec3> points;
    for (size_t t = 0; t < chosen.size(); ++t)
        for (size_t k = 0; chosen[t] && k < 3; ++k) points.push_back(mesh.position(t, k));
    return smallest_sphere(points);
}

// Spread evenly over the sphere, along a spiral.
std::vector<Vec3> side_normals()
{
    constexpr double kGoldenTurn = 2.39996322972865332;
    std::vector<Vec3> normals;
    for (int k = 0; k < kSides; ++k) {
        const double z = 1 - (2 * k + 1.0) / kSides, r = std::sqrt(1 - z * z);
        normals.push_back({static_cast<float>(r * std::cos(kGoldenTurn * k)),
                           static_cast<float>(r * std::sin(kGoldenTurn * k)), static_cast<float>(z)});
    }
    return normals;
}

// A corner of what is left of a triangle: its place, in radii from the centre, and its shares of the three corners.
struct CutCorner {
    Vec3 place;
    std::array<float, 3> shares;
};

CutCorner between(const CutCorner& a, const CutCorner& b, float f)
{
    CutCorner c = {a.place * (1 - f) + b.place * f, {}};
    for (size_t k = 0; k < 3; ++k) c.shares[k] = a.shares[k] * (1 - f) + b.shares[k] * f;
    return c;
}

// Cuts the polygon off at the plane of height 1 (Sutherland and Hodgman).
std::vector<CutCorner> below(const std::vector<CutCorner>& polygon, const Vec3& normal)
{
    std::vector<CutCorner> kept;
    for (size_t k = 0; k < polygon.size(); ++k) {
        const CutCorner &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const float ha = dot(a.place, normal) - 1, hb = dot(b.place, normal) - 1;
        if (ha <= 0) kept.push_back(a);
        if ((ha <= 0) != (hb <= 0)) kept.push_back(between(a, b, ha / (ha - hb)));
    }
    return kept;
}

// Copies triangles of a mesh, whole or in pieces; new corners get places of their own.
class Cutting
{
public:
    Cutting(Mesh& mesh, const BoundingSphere& inner) : mesh_(mesh), inner_(inner) {}

    void keep(size_t t)
    {
        corners_.push_back(mesh_.corners[t]);
        shading_.push_back(mesh_.shading[t]);
        mapping_.push_back(mesh_.mapping[t]);
        materials_.push_back(mesh_.materials[t]);
    }

    void cut(size_t t)
    {
        std::vector<CutCorner> polygon;
        for (size_t k = 0; k < 3; ++k) {
            polygon.push_back({in_radii(mesh_.position(t, k)), {}});
            polygon.back().shares[k] = 1;
        }
        const auto is_inside = [](const CutCorner& c) { return dot(c.place, c.place) <= 1; };
        if (std::all_of(polygon.begin(), polygon.end(), is_inside)) return keep(t);
        for (const Vec3& normal : normals_) {
            polygon = below(polygon, normal);
            if (polygon.empty()) return;
        }
        for (size_t k = 2; k < polygon.size(); ++k) add_piece(t, {polygon[0], polygon[k - 1], polygon[k]});
    }

    void finish()
    {
        mesh_.corners = std::move(corners_);
        mesh_.shading = std::move(shading_);
        mesh_.mapping = std::move(mapping_);
        mesh_.materials = std::move(materials_);
    }

private:
    Vec3 in_radii(const Vec3& p) const
    {
        const auto axis = [&](float c, size_t k) {
            return static_cast<float>((static_cast<double>(c) - inner_.centre[k]) / inner_.radius);
        };
        return {axis(p.x, 0), axis(p.y, 1), axis(p.z, 2)};
    }

    void add_piece(size_t t, const std::array<CutCorner, 3>& piece)
    {
        const Vec3 area = cross(piece[1].place - piece[0].place, piece[2].place - piece[0].place);
        constexpr float kLeast = 1e-9f;  // slivers between two cuts
        if (!(length(area) > kLeast)) return;
        Mesh::Corners corners{};
        Mesh::OptionalCorners shading = mesh_.shading[t], mapping = mesh_.mapping[t];
        for (size_t k = 0; k < 3; ++k) {
            const std::array<float, 3>& s = piece[k].shares;
            corners[k] = static_cast<uint32_t>(mesh_.positions.size());
            mesh_.positions.push_back(mesh_.position(t, 0) * s[0] + mesh_.position(t, 1) * s[1] +
                                      mesh_.position(t, 2) * s[2]);
            if (shading[0] != kNoIndex) shading[k] = add_normal(mesh_.shading[t], s);
            if (mapping[0] != kNoIndex) mapping[k] = add_uv(mesh_.mapping[t], s);
        }
        corners_.push_back(corners);
        shading_.push_back(shading);
        mapping_.push_back(mapping);
        materials_.push_back(mesh_.materials[t]);
    }

    int32_t add_normal(const Mesh::OptionalCorners& of, const std::array<float, 3>& s)
    {
        Vec3 sum;
        for (size_t k = 0; k < 3; ++k) sum = sum + mesh_.normals[static_cast<size_t>(of[k])] * s[k];
        const float size = length(sum);
        mesh_.normals.push_back(size > 0 ? sum / size : mesh_.normals[static_cast<size_t>(of[0])]);
        return static_cast<int32_t>(mesh_.normals.size() - 1);
    }

    int32_t add_uv(const Mesh::OptionalCorners& of, const std::array<float, 3>& s)
    {
        const auto mean = [&](const std::vector<Vec2>& uvs) {
            Vec2 sum;
            for (size_t k = 0; k < 3; ++k) {
                const Vec2& uv = uvs[static_cast<size_t>(of[k])];
                sum = {sum.x + uv.x * s[k], sum.y + uv.y * s[k]};
            }
            return sum;
        };
        const auto has_second = [&](int32_t uv) { return static_cast<size_t>(uv) < mesh_.second_uvs.size(); };
        if (has_second(of[0]) && has_second(of[1]) && has_second(of[2])) {
            mesh_.second_uvs.resize(mesh_.uvs.size());
            mesh_.second_uvs.push_back(mean(mesh_.second_uvs));
        }
        mesh_.uvs.push_back(mean(mesh_.uvs));
        return static_cast<int32_t>(mesh_.uvs.size() - 1);
    }

    Mesh& mesh_;
    const BoundingSphere inner_;
    const std::vector<Vec3> normals_ = side_normals();
    std::vector<Mesh::Corners> corners_;
    std::vector<Mesh::OptionalCorners> shading_, mapping_;
    std::vector<uint32_t> materials_;
};

}  // namespace

void frame_part(const std::filesystem::path& file, const std::string& name, SceneParts& parts)
{
    const auto fail = [&](const std::string& text) { throw SceneError(at({file.string()}, text)); };
    if (parts.volume)
        fail("--frame is for triangles alone; give a 'sphere' in the scene file, or leave out the volume");
    const std::vector<bool> chosen = triangles_named(name, file.string(), parts);
    BoundingSphere sphere = sphere_around(chosen, parts.mesh);
    Cutting cutting(parts.mesh, sphere);
    for (size_t t = 0; t < chosen.size(); ++t) chosen[t] ? cutting.keep(t) : cutting.cut(t);
    cutting.finish();
    parts.named.clear();
    sphere.radius *= 1 + kMargin;
    parts.sphere = sphere;
}

}  // namespace lumi::baker
