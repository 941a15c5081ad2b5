// SPDX-License-Identifier: MIT
#include "model/obj_reader.h"

#include <algorithm>
#include <map>
#include <set>

#include "geometry/polygon.h"
#include "model/materials.h"
#include "model/obj_parser.h"
#include "model/obj_text.h"

namespace lumi::baker
{
namespace
{

using Key = std::pair<uint32_t, int32_t>;  // group, vertex

// Newell's sum: the area vector of a polygon, bent or not.
Vec3 area_vector(const ObjContent& content, const ObjFace& face)
{
    Vec3 sum;
    const Vec3 base = content.positions[static_cast<size_t>(content.corners[face.first].position)];
    for (uint32_t k = 1; k + 1 < face.count; ++k) {
        const Vec3 a = content.positions[static_cast<size_t>(content.corners[face.first + k].position)] - base;
        const Vec3 b = content.positions[static_cast<size_t>(content.corners[face.first + k + 1].position)] - base;
        sum = sum + cross(a, b);
    }
    return sum;
}

// Gives each corner without a normal, of a face in a smoothing group, the mean of the normals of that group's faces at
// the same vertex, weighted by area. Faces outside groups stay flat.
void smooth_normals(ObjContent& content)
{
    std::map<Key, Vec3> sums;
    for (const ObjFace& face : content.faces) {
        if (face.smoothing != 0) {
            const Vec3 area = area_vector(content, face);
            for (uint32_t k = 0; k < face.count; ++k) {
                Vec3& sum = sums[{face.smoothing, content.corners[face.first + k].position}];
                sum = sum + area;
            }
        }
    }
    std::map<Key, int32_t> places;
    for (const auto& [key, sum] : sums) {
        places[key] = static_cast<int32_t>(content.normals.size());
        content.normals.push_back(sum);
    }
    for (const ObjFace& face : content.faces) {
        for (uint32_t k = 0; k < face.count && face.smoothing != 0; ++k) {
            ObjCorner& corner = content.corners[face.first + k];
            corner.normal = corner.normal == kNoIndex ? places[{face.smoothing, corner.position}] : corner.normal;
        }
    }
}

// The libraries that one mtllib line names: all of it is one name with blanks, or each word is a name.
std::vector<std::filesystem::path> libraries_of(const std::filesystem::path& obj, const ObjText::Library& library,
                                                std::vector<std::string>& warnings)
{
    const std::filesystem::path whole = find_beside(obj, library.name);
    if (!whole.empty()) return {whole};
    std::vector<std::filesystem::path> files;
    std::string missing = library.name;
    for (const std::string_view word : words(library.name)) {
        const std::filesystem::path file = find_beside(obj, std::string(word));
        if (!file.empty()) {
            files.push_back(file);
            missing.clear();
        }
    }
    if (!missing.empty() || library.name.empty()) {
        warnings.push_back(at({obj.string(), library.line},
                              "the material file '" + library.name + "' is missing; put it beside the OBJ file"));
    }
    return files;
}

// The materials of all libraries. Each library is read once, however often the OBJ names it.
std::vector<MtlMaterial> materials_of(const std::filesystem::path& file, const ObjText& obj,
                                      std::vector<std::string>& warnings)
{
    std::vector<MtlMaterial> known;
    std::set<std::string> names, read;
    for (const ObjText::Library& library : obj.libraries) {
        if (!names.insert(library.name).second) continue;
        for (const std::filesystem::path& mtl : libraries_of(file, library, warnings))
            if (read.insert(std::filesystem::weakly_canonical(mtl).string()).second)
                for (MtlMaterial& material : read_mtl(mtl, warnings)) known.push_back(std::move(material));
    }
    return known;
}

// Turns polygons into the triangles of a mesh.
class ObjMeshBuilder
{
public:
    ObjMeshBuilder(const ObjContent& content, uint32_t default_material)
        : content_(content), default_material_(default_material)
    {
        mesh_.positions = content.positions;
        mesh_.uvs = content.uvs;
        for (const Vec3& n : content.normals) {
            const float size = length(n);
            mesh_.normals.push_back(size > 0 && std::isfinite(size) ? n / size : Vec3{});
        }
    }

    // False if some triangle of the face has no area; that one is left out.
    bool add(const ObjFace& face)
    {
        std::vector<Vec3> polygon;
        for (uint32_t k = 0; k < face.count; ++k)
            polygon.push_back(content_.positions[static_cast<size_t>(corner(face, k).position)]);
        bool sound = true;
        for (const std::array<uint32_t, 3>& t : triangulate(polygon)) {
            const bool flat = has_no_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
            sound = sound && !flat;
            if (!flat) add_triangle(face, t);
        }
        return sound;
    }

    Mesh take() { return std::move(mesh_); }

private:
    const ObjCorner& corner(const ObjFace& face, uint32_t k) const { return content_.corners[face.first + k]; }

    void add_triangle(const ObjFace& face, const std::array<uint32_t, 3>& t)
    {
        Mesh::Corners corners{};
        Mesh::OptionalCorners shading{}, mapping{};
        bool shaded = true, mapped = true;
        for (size_t k = 0; k < 3; ++k) {
            const ObjCorner& c = corner(face, t[k]);
            corners[k] = static_cast<uint32_t>(c.position);
            shading[k] = c.normal;
            mapping[k] = c.uv;
            shaded = shaded && c.normal != kNoIndex;
            mapped = mapped && c.uv != kNoIndex;
        }
        mesh_.corners.push_back(corners);
        mesh_.shading.push_back(shaded ? shading : Mesh::OptionalCorners{kNoIndex, kNoIndex, kNoIndex});
        mesh_.mapping.push_back(mapped ? mapping : Mesh::OptionalCorners{kNoIndex, kNoIndex, kNoIndex});
        mesh_.materials.push_back(face.material == kNoIndex ? default_material_ : static_cast<uint32_t>(face.material));
    }

    const ObjContent& content_;
    uint32_t default_material_;
    Mesh mesh_;
};

Mesh build_mesh(const std::string& file, const ObjText& obj, const ObjContent& content,
                std::vector<std::string>& warnings)
{
    ObjMeshBuilder builder(content, static_cast<uint32_t>(obj.materials.size()));
    size_t flat_faces = 0, first_flat = 0;
    for (size_t f = 0; f < content.faces.size(); ++f) {
        if (!builder.add(content.faces[f])) {
            first_flat = flat_faces == 0 ? f : first_flat;
            ++flat_faces;
        }
    }
    Mesh mesh = builder.take();
    if (flat_faces != 0) {
        warnings.push_back(at({file, obj.face_lines[first_flat]},
                              std::to_string(flat_faces) + " face(s) from here on are or contain triangles without "
                                                           "area, which are left out; merge doubled vertices"));
    }
    if (mesh.corners.empty()) throw SceneError(at({file}, "no face has an area; check the scale and the vertices"));
    return mesh;
}

}  // namespace

SceneParts read_obj(const std::filesystem::path& file, std::vector<std::string>& warnings)
{
    const ObjText obj = prepare_obj(file.string(), read_text(file));
    const std::vector<MtlMaterial> known = materials_of(file, obj, warnings);
    ObjContent content = parse_obj(file.string(), obj.text, obj.materials.size());
    if (content.faces.size() != obj.face_lines.size())
        throw SceneError(at({file.string()}, "the parser lost faces; export it again as triangles"));
    smooth_normals(content);

    SceneParts parts;
    parts.mesh = build_mesh(file.string(), obj, content, warnings);
    MaterialSet set = resolve_materials(file.string(), obj.materials, known, warnings);
    parts.materials = std::move(set.materials);
    const auto& used = parts.mesh.materials;
    if (std::find(used.begin(), used.end(), obj.materials.size()) != used.end())
        parts.materials.emplace_back().finish();  // the material of faces before the first usemtl
    parts.textures = std::move(set.textures);
    return parts;
}

}  // namespace lumi::baker
