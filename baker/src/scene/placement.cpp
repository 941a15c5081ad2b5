// SPDX-License-Identifier: MIT
#include "scene/placement.h"

#include <algorithm>
#include <utility>

#include "scene/scene_members.h"

namespace lumi::baker
{
namespace
{

constexpr uint32_t kDiscSegments = 128;

Vec3 turned(const Vec3& v, const Vec3& degrees)
{
    constexpr double kRadians = static_cast<double>(kPi) / 180;
    const auto turn = [](double& a, double& b, float angle) {
        const double c = std::cos(static_cast<double>(angle) * kRadians);
        const double s = std::sin(static_cast<double>(angle) * kRadians);
        const double a_old = a;
        a = c * a - s * b;
        b = s * a_old + c * b;
    };
    double x = static_cast<double>(v.x), y = static_cast<double>(v.y), z = static_cast<double>(v.z);
    turn(y, z, degrees.x);
    turn(z, x, degrees.y);
    turn(x, y, degrees.z);
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

template <class Indices>
void shift(Indices& indices, size_t by)
{
    for (auto& index : indices) {
        using Index = std::decay_t<decltype(index)>;
        index = index == static_cast<Index>(kNoIndex) ? index : static_cast<Index>(index + static_cast<Index>(by));
    }
}

template <class T>
void extend(std::vector<T>& list, std::vector<T>& more)
{
    list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void shift_textures(Material& m, size_t by)
{
    for (const auto slot : kTextureSlots)
        if ((m.maps.*slot).used()) (m.maps.*slot).texture += static_cast<int32_t>(by);
}

constexpr NumberRange kScale = {-1e9, 1e9};

// One number for all axes, or three.
void read_scale(JsonMembers& members, Vec3& scale)
{
    const JsonValue* value = members.find("scale");
    if (!value) return;
    if (value->kind == JsonValue::Kind::number) {
        const float all = static_cast<float>(members.number_of(*value, "scale", kScale));
        scale = {all, all, all};
    } else {
        scale = members.vector_of(*value, "scale", kScale);
    }
    constexpr float kLeast = 1e-9f;
    if (std::min({std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)}) < kLeast)
        members.fail(*value, "'scale' flattens the object; choose numbers other than 0");
}

}  // namespace

void place(const Placement& placement, SceneParts& parts)
{
    Mesh& mesh = parts.mesh;
    const Vec3& s = placement.scale;
    const auto& [x, y, z] = std::exchange(parts.origin, {0, 0, 0});
    const std::array<double, 3> o = point_of(affine_of(placement), x, y, z);
    const Vec3 move = {static_cast<float>(o[0]), static_cast<float>(o[1]), static_cast<float>(o[2])};
    for (Vec3& p : mesh.positions) p = turned({p.x * s.x, p.y * s.y, p.z * s.z}, placement.rotation_degrees) + move;
    for (Vec3& n : mesh.normals) {
        const Vec3 scaled = {n.x / s.x, n.y / s.y, n.z / s.z};
        const float size = length(scaled);
        n = size > 0 ? turned(scaled / size, placement.rotation_degrees) : n;
    }
    for (SceneView& view : parts.views) view.to_scene = combined(affine_of(placement), view.to_scene);
    for (NamedPart& part : parts.named)
        if (part.frame) part.frame = combined(affine_of(placement), *part.frame);
    if (s.x * s.y * s.z < 0) {
        for (size_t t = 0; t < mesh.triangle_count(); ++t) {
            std::swap(mesh.corners[t][1], mesh.corners[t][2]);
            std::swap(mesh.shading[t][1], mesh.shading[t][2]);
            std::swap(mesh.mapping[t][1], mesh.mapping[t][2]);
        }
    }
}

Affine affine_of(const Placement& placement)
{
    const Vec3 s = placement.scale, t = placement.translation;
    const Vec3 x = turned({s.x, 0, 0}, placement.rotation_degrees);
    const Vec3 y = turned({0, s.y, 0}, placement.rotation_degrees);
    const Vec3 z = turned({0, 0, s.z}, placement.rotation_degrees);
    const auto row = [](float a, float b, float c, float d) {
        return std::array<double, 4>{static_cast<double>(a), static_cast<double>(b), static_cast<double>(c),
                                     static_cast<double>(d)};
    };
    return {row(x.x, y.x, z.x, t.x), row(x.y, y.y, z.y, t.y), row(x.z, y.z, z.z, t.z)};
}

void append(SceneParts& parts, SceneParts&& other)
{
    Mesh& mesh = other.mesh;
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        shift(mesh.corners[t], parts.mesh.positions.size());
        shift(mesh.shading[t], parts.mesh.normals.size());
        shift(mesh.mapping[t], parts.mesh.uvs.size());
        mesh.materials[t] += static_cast<uint32_t>(parts.materials.size());
    }
    for (NamedPart& part : other.named) {
        part.first += parts.mesh.triangle_count();
        part.end += parts.mesh.triangle_count();
        if (part.bent_end != 0) part.bent_end += parts.mesh.triangle_count();
    }
    extend(parts.named, other.named);
    extend(parts.views, other.views);
    extend(parts.notes, other.notes);
    for (Material& m : other.materials) shift_textures(m, parts.textures.size());
    extend(parts.mesh.positions, mesh.positions);
    extend(parts.mesh.normals, mesh.normals);
    if (!mesh.second_uvs.empty()) parts.mesh.second_uvs.resize(parts.mesh.uvs.size());
    extend(parts.mesh.second_uvs, mesh.second_uvs);
    extend(parts.mesh.uvs, mesh.uvs);
    extend(parts.mesh.corners, mesh.corners);
    extend(parts.mesh.shading, mesh.shading);
    extend(parts.mesh.mapping, mesh.mapping);
    extend(parts.mesh.materials, mesh.materials);
    extend(parts.materials, other.materials);
    extend(parts.textures, other.textures);
}

void append_disc(SceneParts& parts, const Disc& disc, UpAxis up, const Material& material)
{
    Mesh& mesh = parts.mesh;
    const uint32_t centre = static_cast<uint32_t>(mesh.positions.size());
    mesh.positions.push_back(disc.centre);
    for (uint32_t k = 0; k < kDiscSegments; ++k) {
        const float angle = 2 * kPi * static_cast<float>(k) / kDiscSegments;
        const float a = disc.radius * std::cos(angle), b = disc.radius * std::sin(angle);
        mesh.positions.push_back(disc.centre + (up == UpAxis::z ? Vec3{a, b, 0} : Vec3{b, 0, a}));
    }
    for (uint32_t k = 0; k < kDiscSegments; ++k) {
        mesh.corners.push_back({centre, centre + 1 + k, centre + 1 + (k + 1) % kDiscSegments});
        mesh.shading.push_back({kNoIndex, kNoIndex, kNoIndex});
        mesh.mapping.push_back({kNoIndex, kNoIndex, kNoIndex});
        mesh.materials.push_back(static_cast<uint32_t>(parts.materials.size()));
    }
    parts.materials.push_back(material);
}

Placement read_placement(JsonMembers& members)
{
    Placement placement;
    members.vector("translate", kPlace, placement.translation);
    members.vector("rotate", kAngle, placement.rotation_degrees);
    read_scale(members, placement.scale);
    return placement;
}

}  // namespace lumi::baker
