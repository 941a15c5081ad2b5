// SPDX-License-Identifier: MIT
#include "surface.h"

namespace lumi::baker
{
namespace
{

// Far above the rounding error of a hit (some 1e-7) and far below anything a field can show.
constexpr float kOffset = 1e-5f;
// Surfaces that one ray may pass before it counts as stopped: bounds the work in a pathological stack of panes.
constexpr int kMaxPasses = 256;

template <class T, class Items>
T interpolated(const Items& items, const Mesh::OptionalCorners& c, const Hit& hit)
{
    const T& a = items[static_cast<size_t>(c[0])];
    const T& b = items[static_cast<size_t>(c[1])];
    const T& d = items[static_cast<size_t>(c[2])];
    if constexpr (std::is_same_v<T, Vec2>) {
        const float w = 1 - hit.u - hit.v;
        return {w * a.x + hit.u * b.x + hit.v * d.x, w * a.y + hit.u * b.y + hit.v * d.y};
    } else {
        return a * (1 - hit.u - hit.v) + b * hit.u + d * hit.v;
    }
}

// The interpolated normal on the viewer's side; the geometric one where that is missing or faces away.
Vec3 shading_normal(const Mesh& mesh, const Hit& hit, const Vec3& geometric, const Vec3& view)
{
    const Mesh::OptionalCorners& corners = mesh.shading[hit.triangle];
    if (corners[0] == kNoIndex) {
        return geometric;
    }
    const Vec3 mean = interpolated<Vec3>(mesh.normals, corners, hit);
    const float size = length(mean);
    if (!(size > 0)) {
        return geometric;
    }
    const Vec3 normal = mean * ((dot(mean, geometric) < 0 ? -1 : 1) / size);
    return dot(normal, view) > 0 ? normal : geometric;
}

Rgb base_colour(const SceneData& scene, const Material& material, const Hit& hit)
{
    const Mesh::OptionalCorners& corners = scene.mesh.mapping[hit.triangle];
    if (material.base_texture == kNoTexture || corners[0] == kNoIndex) {
        return material.base;
    }
    const Texture& texture = scene.textures[static_cast<size_t>(material.base_texture)];
    return material.base * texture.at(interpolated<Vec2>(scene.mesh.uvs, corners, hit));
}

Vec3 position_at(const Mesh& mesh, const Hit& hit)
{
    return mesh.position(hit.triangle, 0) * (1 - hit.u - hit.v) + mesh.position(hit.triangle, 1) * hit.u +
           mesh.position(hit.triangle, 2) * hit.v;
}

Vec3 facing_normal(const Mesh& mesh, const Hit& hit, const Vec3& view)
{
    const Vec3 normal = normalized(mesh.area_vector(hit.triangle));
    return dot(normal, view) < 0 ? -normal : normal;
}

// The rest of a ray behind a surface that it passes.
Ray beyond(const SceneData& scene, const Ray& ray, const Hit& hit)
{
    const Vec3 away = facing_normal(scene.mesh, hit, ray.direction);
    return {position_at(scene.mesh, hit) + away * kOffset, ray.direction, ray.end - hit.distance};
}

float opacity_of(const SceneData& scene, const Hit& hit)
{
    return scene.materials[scene.mesh.materials[hit.triangle]].opacity;
}

}  // namespace

Surface surface_at(const SceneData& scene, const Ray& ray, const Hit& hit)
{
    const Vec3 view = -ray.direction;
    const Vec3 geometric = facing_normal(scene.mesh, hit, view);
    const Material& material = scene.materials[scene.mesh.materials[hit.triangle]];
    return {hit,       position_at(scene.mesh, hit),
            geometric, Frame(shading_normal(scene.mesh, hit, geometric, view)),
            &material, base_colour(scene, material, hit)};
}

Ray Surface::ray_towards(const Vec3& direction) const
{
    const float side = dot(direction, geometric_normal) < 0 ? -1.0f : 1.0f;
    return {position + geometric_normal * (side * kOffset), direction};
}

Ray Surface::ray_to_light(const Vec3& direction, float distance) const
{
    constexpr float kShort = 1 - 1e-4f;  // stop before the light itself
    Ray ray = ray_towards(direction);
    if (std::isfinite(distance)) {
        const Vec3 towards = position + direction * distance - ray.origin;
        ray.end = length(towards) * kShort;
        ray.direction = normalized(towards);
    }
    return ray;
}

std::optional<Hit> closest_opaque(const SceneData& scene, const Ray& ray, Sampler& sampler)
{
    Ray rest = ray;
    std::optional<Hit> hit = scene.accelerator.closest(rest);
    float travelled = 0;
    for (int k = 0; k < kMaxPasses && hit && scene.has_transparency; ++k) {
        const float opacity = opacity_of(scene, *hit);
        if (opacity >= 1 || sampler.next_1d() < opacity) {
            break;
        }
        travelled += hit->distance;
        rest = beyond(scene, rest, *hit);
        hit = scene.accelerator.closest(rest);
    }
    if (hit) {
        hit->distance += travelled;
    }
    return hit;
}

float transmittance(const SceneData& scene, const Ray& ray)
{
    if (!scene.has_transparency) {
        return scene.accelerator.blocked(ray) ? 0.0f : 1.0f;
    }
    Ray rest = ray;
    float share = 1;
    for (int k = 0; k < kMaxPasses && share > 0; ++k) {
        const std::optional<Hit> hit = scene.accelerator.closest(rest);
        if (!hit) {
            return share;
        }
        share *= 1 - opacity_of(scene, *hit);
        rest = beyond(scene, rest, *hit);
    }
    return 0;
}

}  // namespace lumi::baker
