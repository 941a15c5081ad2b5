// SPDX-License-Identifier: MIT
#include "model/panes.h"
#include "model/readers.h"

#include <algorithm>
#include <map>
#include <set>

#include "geometry/polygon.h"
#include "image/tone.h"
#include "lumi/baker/scene.h"
#include "model/materials.h"
#include "model/tiny_obj.h"
#include "model/vertices.h"

namespace lumi::baker
{
namespace
{

using Key = std::pair<uint32_t, int32_t>;  // group, vertex

// Newell's sum: the area vector of a polygon, bent or not.
Vec3 area_vector(const std::vector<Vec3>& positions, const ObjContent& content, const ObjFace& face)
{
    Vec3 sum;
    const auto corner = [&](uint32_t k) {
        return positions[static_cast<size_t>(content.corners[face.first + k].position)];
    };
    const Vec3 base = corner(0);
    for (uint32_t k = 1; k + 1 < face.count; ++k) {
        const Vec3 a = corner(k) - base, b = corner(k + 1) - base;
        sum = sum + cross(a, b);
    }
    return sum;
}

// Gives each corner without a normal, of a face in a smoothing group, the mean of the normals of that group's faces at
// the same vertex, weighted by area. Faces outside groups stay flat.
void smooth_normals(const std::vector<Vec3>& positions, ObjContent& content)
{
    std::map<Key, Vec3> sums;
    for (const ObjFace& face : content.faces) {
        if (face.smoothing != 0) {
            const Vec3 area = area_vector(positions, content, face);
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

class Libraries
{
public:
    Libraries(const std::filesystem::path& obj, ColourScale colours, Losses& losses, std::vector<std::string>& warnings)
        : obj_(obj), colours_(colours), losses_(losses), warnings_(warnings)
    {
    }

    // The materials of all libraries. Each library is read once, however often the OBJ names it.
    std::vector<MtlMaterial> materials_of(const ObjContent& content)
    {
        std::set<std::string> names;
        for (const ObjName& library : content.libraries)
            if (names.insert(library.name).second) read_all(library);
        if (known_.empty() && !content.materials.empty()) read_namesake();
        return std::move(known_);
    }

private:
    // All of a line is one name with blanks, or each word is a name.
    void read_all(const ObjName& library)
    {
        if (read(library.name, library.line)) return;
        bool found = false;
        for (const std::string_view word : words(library.name)) found = read(std::string(word), library.line) || found;
        if (!found) {
            warnings_.push_back(at({obj_.string(), library.line},
                                   "the material file '" + library.name + "' is missing; put it beside the OBJ file"));
        }
    }

    bool read(const std::string& name, uint32_t line)
    {
        const std::filesystem::path mtl = find_beside(obj_, name);
        if (mtl.empty()) return false;
        if (is_in_other_case(mtl, name))
            losses_.add_at(line, "material file(s) are found by another letter case; write the name as the file's");
        if (read_.insert(std::filesystem::weakly_canonical(mtl).string()).second)
            for (MtlMaterial& material : read_mtl(mtl, warnings_, colours_)) known_.push_back(std::move(material));
        return true;
    }

    // Programs that lose the line still write the file.
    void read_namesake()
    {
        if (read(obj_.stem().string() + ".mtl", 0))
            losses_.add("material file(s) are found by the OBJ's own name; name them in a line 'mtllib'");
    }

    const std::filesystem::path& obj_;
    const ColourScale colours_;
    Losses& losses_;
    std::vector<std::string>& warnings_;
    std::vector<MtlMaterial> known_;
    std::set<std::string> read_;
};

// Turns polygons into the triangles of a mesh.
class ObjMeshBuilder
{
public:
    ObjMeshBuilder(std::vector<Vec3> positions, const ObjContent& content, uint32_t default_material)
        : content_(content), default_material_(default_material)
    {
        mesh_.positions = std::move(positions);
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
            polygon.push_back(mesh_.positions[static_cast<size_t>(corner(face, k).position)]);
        bool sound = true;
        for (const std::array<uint32_t, 3>& t : triangulate(polygon)) {
            const bool flat = has_no_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
            sound = sound && !flat;
            if (!flat) add_triangle(face, t);
        }
        return sound;
    }

    size_t triangle_count() const { return mesh_.triangle_count(); }
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

// Also names the mesh's parts.
Mesh build_mesh(const std::string& file, std::vector<Vec3> positions, const ObjContent& content,
                std::vector<NamedPart>& named, Losses& losses)
{
    std::vector<size_t> ends = {0};  // where the triangles of each face end
    ObjMeshBuilder builder(std::move(positions), content, static_cast<uint32_t>(content.materials.size()));
    for (const ObjFace& face : content.faces) {
        if (!builder.add(face))
            losses.add_at(face.line,
                          "face(s) are or contain triangles without area, which are left out; merge doubled vertices");
        ends.push_back(builder.triangle_count());
    }
    for (const ObjPart& part : content.parts) named.push_back({part.name, ends[part.first], ends[part.end]});
    Mesh mesh = builder.take();
    if (mesh.corners.empty()) throw SceneError(at({file}, "no face has an area; check the scale and the vertices"));
    return mesh;
}

bool has_pictures(const Material& m)
{
    return std::any_of(
        kTextureSlots.begin(), kTextureSlots.end(), [&m](auto slot) { return (m.maps.*slot).used(); });
}

CornerColours colours_at(const std::vector<Rgb>& colours, const Mesh::Corners& corners)
{
    return {srgb_linear(colours[corners[0]]), srgb_linear(colours[corners[1]]), srgb_linear(colours[corners[2]])};
}

// Colours at vertices are a picture of materials that have none.
void paint(const std::vector<Rgb>& colours, size_t undefined, SceneParts& parts, Losses& losses)
{
    const auto is_white = [](const Rgb& c) { return std::min({c.r, c.g, c.b}) >= 1; };
    if (std::all_of(colours.begin(), colours.end(), is_white)) return;
    std::vector<CornerColours> corners;
    for (const Mesh::Corners& c : parts.mesh.corners) corners.push_back(colours_at(colours, c));
    const std::vector<Mesh::OptionalCorners> mapping = parts.mesh.mapping;
    const int32_t picture = static_cast<int32_t>(parts.textures.size());
    parts.textures.push_back(picture_of_corners(parts.mesh, 0, corners));
    std::vector<bool> painted;
    for (size_t k = 0; k < parts.materials.size(); ++k) {
        Material& m = parts.materials[k];
        painted.push_back(!has_pictures(m));
        if (!painted[k]) {
            losses.add("material(s) have pictures, and colours at vertices, which are left out; bake them together");
            continue;
        }
        m.maps.base.texture = picture;
        if (k == undefined) m.base = grey(1);
    }
    for (size_t t = 0; t < mapping.size(); ++t)
        if (!painted[parts.mesh.materials[t]]) parts.mesh.mapping[t] = mapping[t];
}

void count_unmapped(const SceneParts& parts, Losses& losses)
{
    size_t count = 0;
    for (size_t t = 0; t < parts.mesh.triangle_count(); ++t)
        count +=
            parts.mesh.mapping[t][0] == kNoIndex && has_pictures(parts.materials[parts.mesh.materials[t]]) ? 1u : 0u;
    losses.add("triangle(s) have no texture coordinates and do not show their material's pictures; unwrap them", count);
}

}  // namespace

SceneParts read_obj(const std::filesystem::path& file, std::vector<std::string>& warnings, ColourScale colours)
{
    Losses losses;
    ObjContent content = read_obj_text(file.string(), read_text(file), losses);
    const std::vector<MtlMaterial> known = Libraries(file, colours, losses, warnings).materials_of(content);
    CentredPositions at = centred(content.positions);
    smooth_normals(at.positions, content);

    SceneParts parts;
    parts.origin = at.origin;
    parts.mesh = build_mesh(file.string(), std::move(at.positions), content, parts.named, losses);
    MaterialSet set = resolve_materials(file.string(), content.materials, known, warnings);
    parts.materials = std::move(set.materials);
    const size_t undefined = content.materials.size();
    const auto& used = parts.mesh.materials;
    if (std::find(used.begin(), used.end(), undefined) != used.end())
        parts.materials.emplace_back().finish();  // the material of faces before the first usemtl
    parts.textures = std::move(set.textures);
    std::vector<bool> glass;
    for (const Material& m : parts.materials) glass.push_back(m.glass);
    losses.add(
        "glass material(s) are open sheets and drawn as thin panes; close their bodies where they should bend light",
        make_panes(parts, glass));
    if (!content.colours.empty()) paint(content.colours, undefined, parts, losses);
    count_unmapped(parts, losses);
    losses.report(file, warnings);
    return parts;
}

}  // namespace lumi::baker
