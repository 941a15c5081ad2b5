// SPDX-License-Identifier: MIT
#include "files/field_mesh.h"

#include <array>
#include <cinttypes>
#include <cstdio>

#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

using Place = std::array<double, 3>;

// From the sphere's frame, where z points up, to the scene's axes.
Place in_scene_axes(const detail::VertexQ14& v, baker::UpAxis up)
{
    constexpr double kOneQ14 = 1 << 14;
    const double x = v.x / kOneQ14, y = v.y / kOneQ14, z = v.z / kOneQ14;
    return up == baker::UpAxis::y ? Place{y, z, x} : Place{x, y, z};
}

void append_vertex(const Place& p, const FieldSphere& sphere, std::string& text)
{
    const auto in_units = [&](size_t k) {
        return static_cast<double>(sphere.centre[k]) + static_cast<double>(sphere.radius) * p[k];
    };
    char line[96];
    std::snprintf(line, sizeof line, "v %.7g %.7g %.7g\n", in_units(0), in_units(1), in_units(2));
    text += line;
}

void append_face(uint32_t a, uint32_t b, uint32_t c, std::string& text)
{
    char line[64];  // vertices count from 1
    std::snprintf(line, sizeof line, "f %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", a + 1, b + 1, c + 1);
    text += line;
}

void append_group(const SeeThroughField& field, const char* name, uint32_t begin, uint32_t end, std::string& text)
{
    if (begin == end) return;
    text += std::string("g ") + name + "\n";
    for (uint32_t k = begin; k < end; ++k) {
        const auto& corner = detail::surface_patch(field, k).corner;
        append_face(corner[0], corner[1], corner[2], text);
        if (corner[3] != detail::format::kNoVertex) append_face(corner[3], corner[2], corner[1], text);
    }
}

}  // namespace

std::string obj_of(const FieldFile& file, baker::UpAxis up)
{
    if (!file.is_surface())
        throw Failure(file.path(), "a chord field is a table of rays and has no mesh",
                      "write its picture (-o OUT.png), or bake a surface field (lumi bake --layout surface)");
    const SeeThroughField& field = file.surface();
    std::string text = "# the mesh of a LumiPath field, in the units of its scene; written by lumi inspect\n";
    for (uint32_t k = 0; k < field.vertex_count; ++k)
        append_vertex(in_scene_axes(detail::surface_vertex(field, k), up), file.sphere(), text);
    append_group(field, "opaque", 0, field.patch_count, text);
    append_group(field, "see_through", field.patch_count, field.patch_count + field.see_through_count, text);
    return text;
}

}  // namespace lumi::tools
