// SPDX-License-Identifier: MIT
// The one file that sees tinyobjloader.
#include "scene/obj_parser.h"

#include <tiny_obj_loader.h>

#include <sstream>

#include "lumi/baker/scene.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

// Materials are found elsewhere; the parser only has to know the names that stand in for them.
class StandInMaterials : public tinyobj::MaterialReader
{
public:
    explicit StandInMaterials(size_t count) : count_(count) {}

    bool operator()(const std::string&, std::vector<tinyobj::material_t>* materials, std::map<std::string, int>* names,
                    std::string*, std::string*) override
    {
        for (size_t k = 0; k < count_; ++k) (*names)[stand_in_name(k)] = static_cast<int>(k);
        materials->resize(count_);
        return true;
    }

private:
    size_t count_;
};

std::vector<Vec3> triples(const std::vector<tinyobj::real_t>& numbers)
{
    std::vector<Vec3> result;
    result.reserve(numbers.size() / 3);
    for (size_t k = 0; k + 2 < numbers.size(); k += 3) result.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
    return result;
}

std::vector<Vec2> pairs(const std::vector<tinyobj::real_t>& numbers)
{
    std::vector<Vec2> result;
    result.reserve(numbers.size() / 2);
    for (size_t k = 0; k + 1 < numbers.size(); k += 2) result.push_back({numbers[k], numbers[k + 1]});
    return result;
}

void append(const tinyobj::mesh_t& mesh, ObjContent& content)
{
    size_t next = 0;
    for (size_t f = 0; f < mesh.num_face_vertices.size(); ++f) {
        const uint32_t count = mesh.num_face_vertices[f];
        content.faces.push_back(
            {static_cast<uint32_t>(content.corners.size()), count, mesh.material_ids[f], mesh.smoothing_group_ids[f]});
        for (uint32_t k = 0; k < count; ++k, ++next) {
            const tinyobj::index_t& i = mesh.indices[next];
            content.corners.push_back({i.vertex_index, i.normal_index, i.texcoord_index});
        }
    }
}

Rgb to_rgb(const tinyobj::real_t* c)
{
    return {c[0], c[1], c[2]};
}

// The parser takes any number; beyond this one no pixel would be found again.
float sound(tinyobj::real_t number, float fallback)
{
    constexpr float kMost = 1e6f;
    return std::abs(number) <= kMost ? number : fallback;
}

MtlMap to_map(const std::string& name, const tinyobj::texture_option_t& options)
{
    MtlMap map;
    map.name = name;
    map.scale = {sound(options.scale[0], 1), sound(options.scale[1], 1)};
    map.offset = {sound(options.origin_offset[0], 0), sound(options.origin_offset[1], 0)};
    map.strength = sound(options.bump_multiplier, 1);
    return map;
}

}  // namespace

ObjContent parse_obj(const std::string& file, const std::string& text, size_t material_count)
{
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string ignored, error;
    std::istringstream stream(text);
    StandInMaterials names(material_count);
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &ignored, &error, &stream, &names, false, false))
        throw SceneError(at({file}, "it cannot be parsed (" + error + "); export it again"));
    ObjContent content;
    content.positions = triples(attributes.vertices);
    content.normals = triples(attributes.normals);
    content.uvs = pairs(attributes.texcoords);
    for (const tinyobj::shape_t& shape : shapes) append(shape.mesh, content);
    return content;
}

std::vector<MtlMaterial> parse_mtl(const std::string& text)
{
    std::map<std::string, int> names;
    std::vector<tinyobj::material_t> materials;
    std::string ignored_warning, ignored_error;
    std::istringstream stream(text);
    tinyobj::LoadMtl(&names, &materials, &stream, &ignored_warning, &ignored_error);
    std::vector<MtlMaterial> result;
    for (const tinyobj::material_t& m : materials) {
        MtlMaterial mtl;
        mtl.name = m.name;
        mtl.kd = to_rgb(m.diffuse);
        mtl.ks = to_rgb(m.specular);
        mtl.ke = to_rgb(m.emission);
        mtl.ns = m.shininess;
        mtl.ni = m.ior;
        mtl.dissolve = m.dissolve;
        mtl.roughness = m.roughness;
        mtl.metalness = m.metallic;
        mtl.coat = m.clearcoat_thickness;
        mtl.coat_roughness = m.clearcoat_roughness;
        mtl.sheen = m.sheen;
        mtl.anisotropy = m.anisotropy;
        mtl.anisotropy_turns = m.anisotropy_rotation;
        mtl.tf = to_rgb(m.transmittance);
        mtl.illum = m.illum;
        mtl.map_kd = to_map(m.diffuse_texname, m.diffuse_texopt);
        mtl.map_ks = to_map(m.specular_texname, m.specular_texopt);
        mtl.map_ke = to_map(m.emissive_texname, m.emissive_texopt);
        mtl.map_pr = to_map(m.roughness_texname, m.roughness_texopt);
        mtl.map_pm = to_map(m.metallic_texname, m.metallic_texopt);
        mtl.map_ps = to_map(m.sheen_texname, m.sheen_texopt);
        mtl.map_d = to_map(m.alpha_texname, m.alpha_texopt);
        const bool normals = !m.normal_texname.empty();
        mtl.map_bump = normals ? to_map(m.normal_texname, m.normal_texopt) : to_map(m.bump_texname, m.bump_texopt);
        result.push_back(std::move(mtl));
    }
    return result;
}

}  // namespace lumi::baker
