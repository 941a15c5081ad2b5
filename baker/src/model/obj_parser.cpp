// SPDX-License-Identifier: MIT
// The one file that sees tinyobjloader.
#include "model/obj_parser.h"

#include <tiny_obj_loader.h>

#include <sstream>

#include "lumi/baker/scene.h"
#include "model/obj_text.h"
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

}  // namespace lumi::baker
