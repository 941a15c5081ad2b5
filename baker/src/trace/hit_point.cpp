// SPDX-License-Identifier: MIT
#include "trace/hit_point.h"

#include "material/texture_slot.h"
#include "math/warp.h"

namespace lumi::baker
{
namespace
{

struct Tangents {
    Vec3 u;            // has any length and lies in the triangle's plane
    float handedness;  // -1 where the picture is mirrored: v grows against cross(normal, u)
};

// Along u and v of the slot's picture. Nothing where the triangle has no texture coordinates or they do not span an
// area.
inline std::optional<Tangents> tangents_of(const Mesh& mesh, const TextureSlot& slot, uint32_t triangle)
{
    const std::optional<CornerUvs> uvs = corner_uvs(mesh, slot, triangle);
    if (!uvs) return std::nullopt;
    const Vec2 p = slot.place(uvs->p), q = slot.place(uvs->q), r = slot.place(uvs->r);
    const float area = (q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y);
    if (area == 0) return std::nullopt;
    const Vec3 e = mesh.position(triangle, 1) - mesh.position(triangle, 0);
    const Vec3 f = mesh.position(triangle, 2) - mesh.position(triangle, 0);
    const float sign = area < 0 ? -1.0f : 1.0f;
    return Tangents{(e * (r.y - p.y) - f * (q.y - p.y)) * sign, sign};
}

// Far above the rounding error of a hit (some 1e-7) and far below anything a field can show.
constexpr float kOffset = 1e-5f;
// Surfaces that one ray may pass before it counts as stopped: bounds the work in a pathological stack of panes.
constexpr int kMaxPasses = 256;
constexpr float kShort = 1 - 1e-4f;  // share of the way to a light: rays stop before the light itself

// The interpolated normal on the viewer's side; the geometric one where that is missing or faces away.
Vec3 shading_normal(const Mesh& mesh, const Hit& hit, const Vec3& geometric, const Vec3& view)
{
    const Mesh::OptionalCorners& corners = mesh.shading[hit.triangle];
    if (corners[0] == kNoIndex) return geometric;
    const Vec3 mean = mesh.normals[static_cast<size_t>(corners[0])] * (1 - hit.u - hit.v) +
                      mesh.normals[static_cast<size_t>(corners[1])] * hit.u +
                      mesh.normals[static_cast<size_t>(corners[2])] * hit.v;
    const float size = length(mean);
    if (!(size > 0)) return geometric;
    const Vec3 normal = mean * ((dot(mean, geometric) < 0 ? -1 : 1) / size);
    return dot(normal, view) > 0 ? normal : geometric;
}

Rgb slot_at(const SceneData& scene, const TextureSlot& slot, const Hit& hit)
{
    return slot_colour(scene.mesh, scene.textures, slot, hit.triangle, {hit.u, hit.v});
}

PointValues values_at(const SceneData& scene, const Material& material, const Hit& hit, bool outside)
{
    const TextureSlots& maps = material.maps;
    const Rgb picture = slot_at(scene, maps.base, hit);
    PointValues values = {material.base * picture, material.metalness * slot_at(scene, maps.metalness, hit).g,
                          slot_at(scene, maps.roughness, hit).g, outside,
                          material.sheen * slot_at(scene, maps.sheen, hit).g};
    if (!material.glass && !material.thin) return values;
    values.transmission = material.transmission * slot_at(scene, maps.transmission, hit).r;
    const Rgb twice = material.tint * picture;
    values.tint = {std::sqrt(twice.r), std::sqrt(twice.g), std::sqrt(twice.b)};
    return values;
}

constexpr float kGrazing = 0.01f;  // the least cosine of a mirrored ray to the surface

// `bent`, turned so far towards the surface's own normal that it mirrors the view to above the surface, as in Cycles.
// There, too, a pixel of a normal map cannot say how the surface hides itself.
Vec3 mirroring_upwards(const Vec3& bent, const Vec3& geometric, const Vec3& view)
{
    const float facing = dot(bent, view);
    const Vec3 towards = facing > 0 ? bent : normalized(bent - view * facing);
    const Vec3 mirrored = towards * (2 * std::max(facing, 0.0f)) - view;
    const float height = dot(mirrored, geometric), least = std::min(kGrazing, 0.9f * dot(view, geometric));
    if (facing > 0 && height >= least) return bent;
    return normalized(normalized(mirrored + geometric * (least - height)) + view);
}

// `normal` bent as the material's normal map says. Glass keeps it where that would face away from the viewer.
Vec3 bent_normal(const SceneData& scene, const Material& material, const Hit& hit, const Vec3& normal,
                 const Vec3& geometric, const Vec3& view, bool outside)
{
    if (!material.maps.normal.used()) return normal;
    const std::optional<Tangents> tangents = tangents_of(scene.mesh, material.maps.normal, hit.triangle);
    if (!tangents) return normal;
    const float side = outside ? 1.0f : -1.0f;
    const Vec3 front = normal * side;
    const Rgb c = slot_at(scene, material.maps.normal, hit);
    const Vec3 across = tangents->u - front * dot(front, tangents->u);
    const Vec3 upright = cross(front, across) * tangents->handedness;
    const float size = length(across);
    if (!(size > 0)) return normal;
    const Vec3 bent = (across * (2 * c.r - 1) + upright * (2 * c.g - 1)) / size + front * (2 * c.b - 1);
    const float bent_size = length(bent);
    if (!(bent_size > 0)) return normal;
    if (!material.glass) return mirroring_upwards(bent * (side / bent_size), geometric, view);
    return dot(bent, view) * side > 0 ? bent * (side / bent_size) : normal;
}

// Where a brushed material's facets spread widest, as seen from the triangle's front: along u, or without texture
// coordinates level, around the vertical axis.
Vec3 brushed_direction(const SceneData& scene, const Material& material, uint32_t triangle, const Vec3& front)
{
    constexpr Vec3 kUp = {0, 0, 1};  // in the sphere's frame
    const std::optional<Tangents> tangents = tangents_of(scene.mesh, {}, triangle);
    const Frame level(front, tangents ? tangents->u : cross(kUp, front));
    const SineCosine turn = sine_cosine_of_turns(material.anisotropy_turns);
    return level.tangent * turn.cosine + level.bitangent * turn.sine;
}

// The local frame; its tangent matters to brushed materials only.
Frame shading_frame(const SceneData& scene, const Material& material, const Hit& hit, const Vec3& normal, bool outside)
{
    if (!material.brushed()) return Frame(normal);
    return Frame(normal, brushed_direction(scene, material, hit.triangle, outside ? normal : -normal));
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

}  // namespace

HitPoint hit_point_at(const SceneData& scene, const Ray& ray, const Hit& hit)
{
    const Vec3 view = -ray.direction;
    const Vec3 geometric = facing_normal(scene.mesh, hit, view);
    const Material& material = scene.materials[scene.mesh.materials[hit.triangle]];
    const bool outside = dot(scene.mesh.area_vector(hit.triangle), view) > 0;
    const Vec3 smooth = shading_normal(scene.mesh, hit, geometric, view);
    return {hit,
            position_at(scene.mesh, hit),
            geometric,
            shading_frame(scene, material, hit, bent_normal(scene, material, hit, smooth, geometric, view, outside),
                          outside),
            &material,
            values_at(scene, material, hit, outside),
            material.emits() ? emission_at(scene.mesh, material, scene.textures, hit.triangle, {hit.u, hit.v}) : Rgb{},
            material.maps.normal.used() && !material.glass};
}

Ray HitPoint::ray_towards(const Vec3& direction) const
{
    const float side = dot(direction, geometric_normal) < 0 ? -1.0f : 1.0f;
    return {position + geometric_normal * (side * kOffset), direction};
}

Ray HitPoint::ray_to_light(const Vec3& direction, float distance) const
{
    Ray ray = ray_towards(direction);
    if (std::isfinite(distance)) {
        const Vec3 towards = position + direction * distance - ray.origin;
        ray.end = length(towards) * kShort;
        ray.direction = normalized(towards);
    }
    return ray;
}

namespace
{

const Material& material_of(const SceneData& scene, const Hit& hit)
{
    return scene.materials[scene.mesh.materials[hit.triangle]];
}

// By the file's alpha alone.
float stated_opacity(const SceneData& scene, const Hit& hit)
{
    const Material& material = material_of(scene, hit);
    return material.opacity * slot_at(scene, material.maps.opacity, hit).g;
}

// The share of light that passes straight on.
Rgb passing_light(const SceneData& scene, const Hit& hit, float cosine)
{
    const Material& material = material_of(scene, hit);
    const float opacity = stated_opacity(scene, hit);
    if (!material.thin) return grey(1 - opacity);
    const Rgb picture = slot_at(scene, material.maps.base, hit);
    return grey(1 - opacity) + material.through_pane(values_at(scene, material, hit, true), picture, cosine) * opacity;
}

float mean_of(const Rgb& c)
{
    return (c.r + c.g + c.b) / 3;
}

}  // namespace

Rgb passing_light(const SceneData& scene, const Hit& hit, const Vec3& direction)
{
    return passing_light(scene, hit, std::abs(dot(normalized(scene.mesh.area_vector(hit.triangle)), direction)));
}

float opacity_of(const SceneData& scene, const Hit& hit)
{
    if (!material_of(scene, hit).thin) return stated_opacity(scene, hit);
    return std::clamp(1 - mean_of(passing_light(scene, hit, 1)), 0.0f, 1.0f);
}

float weight_of_stop(const SceneData& scene, const Hit& hit)
{
    if (!material_of(scene, hit).thin) return 1;
    const float stops = opacity_of(scene, hit);
    return stops > 0 ? stated_opacity(scene, hit) / stops : 1.0f;
}

namespace
{

template <class Passed>
std::optional<Hit> closest_stopping(const SceneData& scene, const Ray& ray, Sampler& sampler, const Passed& passed)
{
    if (scene.mesh_is_shell) return std::nullopt;
    Ray rest = ray;
    std::optional<Hit> hit = scene.accelerator.closest(rest);
    float travelled = 0;
    for (int k = 0; k < kMaxPasses && hit && scene.has_transparency; ++k) {
        const float opacity = opacity_of(scene, *hit);
        if (opacity >= 1 || sampler.next_1d() < opacity) break;
        travelled += hit->distance;
        passed(*hit, travelled, opacity);
        rest = beyond(scene, rest, *hit);
        hit = scene.accelerator.closest(rest);
    }
    if (hit) hit->distance += travelled;
    return hit;
}

}  // namespace

std::optional<Hit> closest_opaque(const SceneData& scene, const Ray& ray, Sampler& sampler)
{
    return closest_stopping(
        scene, ray, sampler, [](const Hit&, float, float) {});
}

std::optional<Hit> closest_opaque(const SceneData& scene, const Ray& ray, Sampler& sampler, Rgb& through)
{
    return closest_stopping(
        scene, ray, sampler,
        [&](const Hit& hit, float, float opacity) {
            if (material_of(scene, hit).thin)
                through = through * passing_light(scene, hit, ray.direction) * (1 / (1 - opacity));
        });
}

std::optional<Hit> closest_opaque(const SceneData& scene, const Ray& ray, Sampler& sampler, std::vector<Hit>& passed)
{
    return closest_stopping(
        scene, ray, sampler,
        [&](Hit hit, float distance, float) {
            hit.distance = distance;
            passed.push_back(hit);
        });
}

float first_meeting(const SceneData& scene, const Ray& ray, Sampler& sampler)
{
    constexpr float kNothing = std::numeric_limits<float>::infinity();
    const std::optional<Hit> hit = closest_opaque(scene, ray, sampler);
    if (!scene.medium) return hit ? hit->distance : kNothing;
    const std::optional<float> stop =
        scene.medium->collision({ray.origin, ray.direction, hit ? hit->distance : ray.end}, sampler);
    return stop ? *stop : hit ? hit->distance : kNothing;
}

Rgb transmittance(const SceneData& scene, const Ray& ray)
{
    if (scene.mesh_is_shell) return grey(1);
    if (!scene.has_transparency) return scene.accelerator.blocked(ray) ? Rgb{} : grey(1);
    Ray rest = ray;
    Rgb share = grey(1);
    for (int k = 0; k < kMaxPasses && !is_black(share); ++k) {
        const std::optional<Hit> hit = scene.accelerator.closest(rest);
        if (!hit) return share;
        share = share * passing_light(scene, *hit, ray.direction);
        rest = beyond(scene, rest, *hit);
    }
    return {};
}

Rgb transmittance(const SceneData& scene, const Ray& ray, Sampler& sampler)
{
    const Rgb share = transmittance(scene, ray);
    return scene.medium && !is_black(share) ? share * scene.medium->transmittance(ray, sampler) : share;
}

Ray ray_to_light(const Vec3& position, const Vec3& direction, float distance)
{
    return {position, direction, distance * kShort};
}

}  // namespace lumi::baker
