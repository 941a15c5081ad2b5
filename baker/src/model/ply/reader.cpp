// SPDX-License-Identifier: MIT
#include "model/readers.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon.h"
#include "image/tone.h"
#include "lumi/baker/scene.h"
#include "model/facets.h"
#include "model/ply/header.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

// A number of a vertex has one of these meanings; the last one stands for none.
enum Role : size_t { kX, kY, kZ, kNormalX, kNormalY, kNormalZ, kRed, kGreen, kBlue, kRoles };

struct RoleName {
    std::string_view name;
    Role role;
};
constexpr RoleName kRoleNames[] = {
    {"x", kX},
    {"y", kY},
    {"z", kZ},
    {"nx", kNormalX},
    {"ny", kNormalY},
    {"nz", kNormalZ},
    {"red", kRed},
    {"green", kGreen},
    {"blue", kBlue},
    {"r", kRed},
    {"g", kGreen},
    {"b", kBlue},
    {"diffuse_red", kRed},
    {"diffuse_green", kGreen},
    {"diffuse_blue", kBlue},
};

Role role_of(const PlyProperty& property)
{
    const auto* found = std::find_if(std::begin(kRoleNames), std::end(kRoleNames),
                                     [&](const RoleName& r) { return r.name == property.name; });
    return property.is_list || found == std::end(kRoleNames) ? kRoles : found->role;
}

// White is 1 in floats, and the largest number of the type in whole numbers.
double white_of(PlyType type)
{
    if (type >= PlyType::float32) return 1;
    const bool has_sign = type == PlyType::int8 || type == PlyType::int16 || type == PlyType::int32;
    return std::exp2(8.0 * static_cast<double>(bytes_of(type)) - (has_sign ? 1 : 0)) - 1;
}

float linear_of(double encoded, PlyType type)
{
    const double unit = encoded / white_of(type);
    return unit > 0 ? static_cast<float>(srgb_linear(std::min(unit, 1.0))) : 0.0f;
}

class PlyReader
{
public:
    PlyReader(const std::filesystem::path& file, std::string_view bytes)
        : file_(file.string()), header_(read_ply_header(file, bytes)), numbers_(file, header_, bytes)
    {
    }

    Facets read(Losses& losses)
    {
        refuse_points();
        losses.add("line(s) of the heading are not understood and left out; check the picture", header_.strange_lines);
        if (!header_.picture.empty())
            losses.add("picture(s) ('" + header_.picture +
                       "') are left out; export glTF or OBJ, in MeshLab for example");
        for (const PlyElement& element : header_.elements) {
            if (element.properties.empty()) continue;  // takes no bytes, however many there are
            numbers_.require(element);
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element, losses);
            else
                skip(element, losses);
        }
        if (numbers_.ends_in_a_number())
            losses.add("line(s) at the end have no line end; if something is missing, copy or export the file again");
        losses.add("line(s) have more numbers than the heading says, which are left out; export it again", surplus_);
        check_faces();
        return std::move(facets_);
    }

    bool z_is_up() const { return header_.by_blender; }

private:
    [[noreturn]] void fail(const std::string& text) const { throw SceneError(at({file_}, text)); }

    const PlyElement* find(std::string_view name) const
    {
        const auto found = std::find_if(header_.elements.begin(), header_.elements.end(),
                                        [&](const PlyElement& e) { return e.name == name; });
        return found == header_.elements.end() ? nullptr : &*found;
    }

    void refuse_points() const
    {
        const PlyElement* faces = find("face");
        if (faces && faces->count != 0) return;
        const PlyElement* vertices = find("vertex");
        if (!vertices || vertices->count == 0) fail("there is no face in it; export at least one mesh");
        if (find("tristrips")) fail("its faces are strips, which are not read; convert it to triangles in MeshLab");
        if (vertices->find("f_dc_0"))
            fail("these are Gaussian splats, which have no surface; export a mesh from the program that made them");
        fail("this is a cloud of " + std::to_string(vertices->count) +
             " points, which has no surface; make a mesh of it (in MeshLab: Screened Poisson), and export PLY");
    }

    void read_vertices(const PlyElement& element)
    {
        std::vector<Role> roles;
        std::array<bool, kRoles + 1> has{};
        for (const PlyProperty& p : element.properties) has[roles.emplace_back(role_of(p))] = true;
        if (!has[kX] || !has[kY] || !has[kZ]) fail("its vertices have no x, y and z; export it again");
        for (uint64_t k = 0; k < element.count; ++k) {
            const std::array<double, kRoles> v = next_vertex(element, roles);
            surplus_ += numbers_.skip_line() ? 1u : 0u;
            check_position(v);
            facets_.positions.push_back({v[kX], v[kY], v[kZ]});
            if (has[kNormalX] && has[kNormalY] && has[kNormalZ])
                facets_.normals.push_back({static_cast<float>(v[kNormalX]), static_cast<float>(v[kNormalY]),
                                           static_cast<float>(v[kNormalZ])});
            if (has[kRed] && has[kGreen] && has[kBlue])
                facets_.colours.push_back(
                    {static_cast<float>(v[kRed]), static_cast<float>(v[kGreen]), static_cast<float>(v[kBlue])});
        }
    }

    std::array<double, kRoles> next_vertex(const PlyElement& element, const std::vector<Role>& roles)
    {
        std::array<double, kRoles> values{};
        for (size_t k = 0; k < roles.size(); ++k) {
            const PlyProperty& p = element.properties[k];
            if (roles[k] == kRoles) {
                skip(p);
                continue;
            }
            const double value = numbers_.next(p.type);
            values[roles[k]] = roles[k] >= kRed ? static_cast<double>(linear_of(value, p.type)) : value;
        }
        return values;
    }

    void check_position(const std::array<double, kRoles>& v) const
    {
        for (const Role role : {kX, kY, kZ}) {
            if (!(std::abs(v[role]) <= kMaxCoordinate)) {
                numbers_.fail("vertex " + std::to_string(facets_.positions.size()) +
                              " has a coordinate that is not finite or above " + number_text(kMaxCoordinate) +
                              "; export it again");
            }
        }
    }

    void read_faces(const PlyElement& element, Losses& losses)
    {
        const bool named = element.find("vertex_indices") || element.find("vertex_index");
        if (!named) fail("its faces have no list 'vertex_indices'; export it again");
        for (uint64_t k = 0; k < element.count; ++k) {
            for (const PlyProperty& p : element.properties)
                if (p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index"))
                    take_face(next_list(p), losses);
                else
                    skip(p);
            surplus_ += numbers_.skip_line() ? 1u : 0u;
        }
    }

    std::vector<uint32_t> next_list(const PlyProperty& list)
    {
        const uint64_t count = next_count(list);
        std::vector<uint32_t> corners;
        corners.reserve(count);
        for (uint64_t k = 0; k < count; ++k) {
            const double index = numbers_.next(list.type);
            constexpr double kMost = 4294967294;
            if (!(index >= 0 && index <= kMost && index == std::floor(index)))
                numbers_.fail("a face uses vertex " + number_text(index) + ", which cannot be; export it again");
            corners.push_back(static_cast<uint32_t>(index));
        }
        return corners;
    }

    uint64_t next_count(const PlyProperty& list)
    {
        const double count = numbers_.next(list.count_type);
        constexpr double kMost = 4294967295;  // PLY's widest type of a count holds it; a text may state more
        if (!(count >= 0 && count <= kMost))
            numbers_.fail("a list has " + number_text(count) + " numbers, which cannot be; export it again");
        numbers_.require(static_cast<uint64_t>(count), list.type);
        return static_cast<uint64_t>(count);
    }

    void skip_list(const PlyProperty& list)
    {
        for (uint64_t k = next_count(list); k > 0; --k) numbers_.next(list.type);
    }

    void skip(const PlyProperty& p) { p.is_list ? skip_list(p) : static_cast<void>(numbers_.next(p.type)); }

    void skip(const PlyElement& element, Losses& losses)
    {
        for (uint64_t k = 0; k < element.count; ++k)
            for (const PlyProperty& p : element.properties) skip(p);
        losses.add("element(s) '" + element.name + "' are left out; only faces are drawn", element.count);
    }

    void take_face(const std::vector<uint32_t>& corners, Losses& losses)
    {
        if (corners.size() < 3)
            losses.add("face(s) have fewer than three corners and are left out; remove them");
        else if (corners.size() == 3)
            facets_.triangles.push_back({corners[0], corners[1], corners[2]});
        else
            polygons_.push_back(corners);
    }

    // Faces may come before their vertices.
    void check_faces()
    {
        for (const Mesh::Corners& t : facets_.triangles)
            for (const uint32_t c : t) check_corner(c);
        for (const std::vector<uint32_t>& corners : polygons_) {
            for (const uint32_t c : corners) check_corner(c);
            cut(corners);
        }
        const bool short_of_normals = facets_.normals.size() < facets_.positions.size();
        if (short_of_normals) facets_.normals.clear();
        if (facets_.colours.size() < facets_.positions.size()) facets_.colours.clear();
    }

    void check_corner(uint32_t corner) const
    {
        if (corner >= facets_.positions.size()) {
            fail("a face uses vertex " + std::to_string(corner) + ", but there are " +
                 std::to_string(facets_.positions.size()) + "; the file is damaged, export it again");
        }
    }

    void cut(const std::vector<uint32_t>& corners)
    {
        std::vector<Point> around;
        for (const uint32_t c : corners) around.push_back(facets_.positions[c]);
        for (const std::array<uint32_t, 3>& t : triangulate(centred(around).positions))
            facets_.triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
    }

    std::string file_;
    PlyHeader header_;
    PlyNumbers numbers_;
    Facets facets_;
    std::vector<std::vector<uint32_t>> polygons_;
    size_t surplus_ = 0;  // lines
};

}  // namespace

bool is_ply(std::string_view head)
{
    return head.substr(0, 4) == "ply\n" || head.substr(0, 4) == "ply\r";
}

SceneParts read_ply(const std::filesystem::path& file, std::vector<std::string>& warnings)
{
    const std::string bytes = read_file(file);
    Losses losses;
    PlyReader reader(file, bytes);
    SceneParts parts = parts_of_facets(file, reader.read(losses), losses);
    if (reader.z_is_up()) {
        parts.up = UpAxis::z;
        parts.notes.emplace_back("z points up, as Blender writes PLY; --up y turns it");
    }
    losses.report(file, warnings);
    return parts;
}

}  // namespace lumi::baker
