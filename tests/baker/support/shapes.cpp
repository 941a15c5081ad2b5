// SPDX-License-Identifier: MIT
#include "support/shapes.h"

#include "math/vec3.h"
#include "math/warp.h"

namespace lumi::baker::testing
{

Material diffuse(const Rgb& albedo)
{
    Material m;
    m.base = albedo;
    m.finish();
    return m;
}

Material glossy(const Rgb& albedo, float alpha)
{
    Material m;
    m.base = albedo;
    m.specular = true;
    m.alpha = alpha;
    m.finish();
    return m;
}

Material metal(const Rgb& f0, float alpha)
{
    Material m;
    m.base = f0;
    m.metalness = 1;
    m.alpha = alpha;
    m.finish();
    return m;
}

Material lamp(const Rgb& radiance)
{
    Material m;
    m.base = grey(0);
    m.emission = radiance;
    m.finish();
    return m;
}

Material glass(float index, float alpha, const Rgb& transmittance)
{
    Material m;
    m.glass = true;
    m.index = index;
    m.alpha = alpha;
    m.transmittance = transmittance;
    m.finish();
    return m;
}

uint32_t SceneMaker::add(const Material& material)
{
    parts_.materials.push_back(material);
    return static_cast<uint32_t>(parts_.materials.size() - 1);
}

void SceneMaker::add(const Fixture& fixture)
{
    parts_.fixtures.push_back(fixture);
}

void SceneMaker::fill(const Volume& volume)
{
    parts_.volume = volume;
}

void SceneMaker::surround(const Environment& environment)
{
    parts_.environment = environment;
}

void SceneMaker::see_through(ToneCurve tone)
{
    parts_.tone = tone;
}

void SceneMaker::expose(float factor)
{
    parts_.exposure = factor;
}

void SceneMaker::triangle(uint32_t material, const Vec3& a, const Vec3& b, const Vec3& c)
{
    Mesh& m = parts_.mesh;
    const uint32_t first = static_cast<uint32_t>(m.positions.size());
    m.positions.insert(m.positions.end(), {a, b, c});
    m.corners.push_back({first, first + 1, first + 2});
    m.shading.push_back({kNoIndex, kNoIndex, kNoIndex});
    m.mapping.push_back({kNoIndex, kNoIndex, kNoIndex});
    m.materials.push_back(material);
    parts_.moving.owners.push_back(static_cast<uint8_t>(parts_.moving.motions.size()));
}

void SceneMaker::begin_part(const PartMovement& movement)
{
    parts_.moving.motions.push_back(movement);
}

void SceneMaker::quad(uint32_t material, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    triangle(material, a, b, c);
    triangle(material, a, c, d);
}

void SceneMaker::ball(uint32_t material, const Vec3& centre, float radius, int rings)
{
    const auto at = [&](int ring, int step) {
        const float angle = kPi * static_cast<float>(ring) / static_cast<float>(rings);
        const float turn = static_cast<float>(step % (2 * rings)) / static_cast<float>(2 * rings);
        return centre + direction_at(std::cos(angle), turn) * radius;
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int step = 0; step < 2 * rings; ++step) {
            if (ring > 0) triangle(material, at(ring, step), at(ring + 1, step), at(ring, step + 1));
            if (ring < rings - 1) triangle(material, at(ring, step + 1), at(ring + 1, step), at(ring + 1, step + 1));
        }
    }
}

void SceneMaker::box(uint32_t material, const Vec3& l, const Vec3& h)
{
    quad(material, {l.x, l.y, l.z}, {l.x, h.y, l.z}, {h.x, h.y, l.z}, {h.x, l.y, l.z});
    quad(material, {l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, h.y, h.z}, {l.x, h.y, h.z});
    quad(material, {l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, l.y, h.z}, {l.x, l.y, h.z});
    quad(material, {l.x, h.y, l.z}, {l.x, h.y, h.z}, {h.x, h.y, h.z}, {h.x, h.y, l.z});
    quad(material, {l.x, l.y, l.z}, {l.x, l.y, h.z}, {l.x, h.y, h.z}, {l.x, h.y, l.z});
    quad(material, {h.x, l.y, l.z}, {h.x, h.y, l.z}, {h.x, h.y, h.z}, {h.x, l.y, h.z});
}

void SceneMaker::tilt_normals(uint32_t material, float sine)
{
    const auto byte = [](float v) { return static_cast<uint8_t>(std::lround((v * 0.5f + 0.5f) * 255)); };
    parts_.textures.push_back({1, 1, {byte(sine), byte(0), byte(std::sqrt(1 - sine * sine))}, false});
    parts_.materials[material].maps.normal.texture = static_cast<int32_t>(parts_.textures.size() - 1);
    parts_.mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    parts_.mesh.mapping = {{0, 1, 2}, {0, 2, 3}};
}

void SceneMaker::span_unit_sphere()
{
    constexpr float kSpeck = 1e-4f;
    const uint32_t black = add(diffuse(grey(0)));
    for (const Vec3& p : {Vec3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
        const Frame frame(p);
        const Vec3 inner = p * (1 - kSpeck);
        triangle(black, p, inner + frame.tangent * kSpeck, inner + frame.bitangent * kSpeck);
    }
}

Scene SceneMaker::make(const Environment& environment)
{
    parts_.environment = environment;
    parts_.exposure = parts_.exposure.value_or(1.0f);
    return make_open();
}

Scene SceneMaker::make_open()
{
    LoadOptions options;
    options.up = UpAxis::z;
    options.margin = 0;
    return build_scene(std::move(parts_), options);
}

}  // namespace lumi::baker::testing
