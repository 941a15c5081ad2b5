// SPDX-License-Identifier: MIT
// The one file that sees tinyobjloader. It is compiled here, so that sanitizers and fuzzing see it too.
#include "model/tiny_obj.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <istream>
#include <map>
#include <optional>
#include <sstream>

#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace lumi::baker
{
namespace
{

// Whether they run to 255: no brighter light than 4 is likely, but all of a file's bytes may be small.
bool are_bytes(const std::vector<Rgb>& colours)
{
    constexpr float kNearlyOne = 1.01f, kMostLight = 4;
    const auto is_whole = [](float c) { return c == std::floor(c); };
    float most = 0;
    bool are_whole = true;
    for (const Rgb& c : colours) {
        most = std::max(most, max_component(c));
        are_whole = are_whole && is_whole(c.r) && is_whole(c.g) && is_whole(c.b);
    }
    return most > kMostLight || (most > kNearlyOne && are_whole);
}

// Takes what the package delivers of an OBJ text, and asks the lines for the rest.
class ObjBuilder
{
public:
    explicit ObjBuilder(const ObjLines& lines) : lines_(lines) {}

    void add_position(const Point& position)
    {
        if (lines_.colour()) {
            out_.colours.resize(out_.positions.size(), kNoColour);
            out_.colours.push_back(*lines_.colour());
        }
        out_.positions.push_back(position);
    }

    void add_normal(const Vec3& normal) { out_.normals.push_back(normal); }
    void add_uv(const Vec2& uv) { out_.uvs.push_back(uv); }

    void add_face(const tinyobj::index_t* corners, int count)
    {
        const uint32_t first = static_cast<uint32_t>(out_.corners.size());
        for (int k = 0; k < count; ++k) {
            const tinyobj::index_t& c = corners[k];
            out_.corners.push_back({from_zero(c.vertex_index, out_.positions.size()),
                                    from_zero(c.normal_index, out_.normals.size()),
                                    from_zero(c.texcoord_index, out_.uvs.size())});
        }
        out_.faces.push_back(
            {first, static_cast<uint32_t>(count), material_, lines_.smoothing(), lines_.line().number});
    }

    void use_material(const std::string& name)
    {
        const auto [entry, fresh] = places_.try_emplace(name, static_cast<int32_t>(out_.materials.size()));
        if (fresh) out_.materials.push_back({name, lines_.line().number});
        material_ = entry->second;
    }

    // The package divides a group's name at its blanks, so both names are those of the line.
    void begin_object()
    {
        end_part(object_);
        begin_part(object_);
    }
    void begin_group() { begin_part(group_); }

    ObjContent finish()
    {
        for (const ObjFace& face : out_.faces)
            for (uint32_t k = 0; k < face.count; ++k) check(face, out_.corners[face.first + k]);
        end_part(object_);
        end_part(group_);
        finish_colours();
        out_.libraries = lines_.libraries;
        return std::move(out_);
    }

private:
    static constexpr Rgb kNoColour = {-1, -1, -1};

    // From an index of OBJ: from 1, or back from the last one so far; 0 for none.
    static int32_t from_zero(int index, size_t count)
    {
        if (index == 0) return kNoIndex;
        return index > 0 ? index - 1 : static_cast<int32_t>(static_cast<int64_t>(count) + index);
    }

    void begin_part(std::optional<size_t>& part)
    {
        end_part(group_);
        part = out_.parts.size();
        out_.parts.push_back({lines_.line().argument, out_.faces.size(), 0});
    }

    void end_part(std::optional<size_t>& part)
    {
        if (part) out_.parts[*part].end = out_.faces.size();
        part.reset();
    }

    void check(const ObjFace& face, const ObjCorner& corner) const
    {
        check(face, corner.position, "vertex", out_.positions.size());
        check(face, corner.uv, "texture coordinate", out_.uvs.size());
        check(face, corner.normal, "normal", out_.normals.size());
    }

    void check(const ObjFace& face, int32_t index, const char* name, size_t count) const
    {
        if (index >= 0 && static_cast<size_t>(index) >= count)
            fail_beyond({lines_.place().file, face.line}, name, int64_t{index} + 1, count);
    }

    // Some programs write colours to 255, others a little beyond 1. Positions without a colour are white.
    void finish_colours()
    {
        if (out_.colours.empty()) return;
        out_.colours.resize(out_.positions.size(), kNoColour);
        const float scale = are_bytes(out_.colours) ? 1.0f / 255 : 1.0f;
        const auto part = [&](float c) { return std::min(1.0f, scale * c); };
        for (Rgb& c : out_.colours) c = c.r < 0 ? grey(1) : Rgb{part(c.r), part(c.g), part(c.b)};
    }

    const ObjLines& lines_;
    ObjContent out_;
    std::map<std::string, int32_t> places_;  // where materials stand
    int32_t material_ = kNoIndex;
    std::optional<size_t> object_, group_;  // parts that the next face belongs to
};

ObjBuilder& builder(void* data)
{
    return *static_cast<ObjBuilder*>(data);
}

float single(double number)
{
    return static_cast<float>(number);
}

tinyobj::callback_t callbacks()
{
    tinyobj::callback_t to;
    to.vertex_cb = [](void* b, double x, double y, double z, double) { builder(b).add_position({x, y, z}); };
    to.normal_cb = [](void* b, double x, double y, double z) {
        builder(b).add_normal({single(x), single(y), single(z)});
    };
    to.texcoord_cb = [](void* b, double u, double v, double) { builder(b).add_uv({single(u), single(v)}); };
    to.index_cb = [](void* b, tinyobj::index_t* corners, int count) { builder(b).add_face(corners, count); };
    to.usemtl_cb = [](void* b, const char* name, int) { builder(b).use_material(name); };
    to.object_cb = [](void* b, const char*) { builder(b).begin_object(); };
    to.group_cb = [](void* b, const char**, int) { builder(b).begin_group(); };
    return to;
}

using Read = tinyobj::material_t;

struct ColourField {
    const char* keyword;
    double (Read::*colour)[3];
};
constexpr ColourField kColourFields[] = {
    {"Kd", &Read::diffuse}, {"Ks", &Read::specular}, {"Ke", &Read::emission}, {"Tf", &Read::transmittance}};

// The package keeps these words of MTL in numbers of its own; mtl_reader.cpp lists all that have a meaning.
struct NumberField {
    const char* keyword;
    double Read::*number;
};
constexpr NumberField kNumbers[] = {
    {"Ns", &Read::shininess},
    {"Ni", &Read::ior},
    {"d", &Read::dissolve},
    {"Pr", &Read::roughness},
    {"Pm", &Read::metallic},
    {"Ps", &Read::sheen},
    {"Pc", &Read::clearcoat_thickness},
    {"Pcr", &Read::clearcoat_roughness},
    {"aniso", &Read::anisotropy},
    {"anisor", &Read::anisotropy_rotation},
};

struct MapField {
    const char* keyword;
    std::string Read::*name;
    tinyobj::texture_option_t Read::*options;
};
constexpr MapField kMapFields[] = {
    {"map_Kd", &Read::diffuse_texname, &Read::diffuse_texopt},
    {"map_Ks", &Read::specular_texname, &Read::specular_texopt},
    {"map_Ke", &Read::emissive_texname, &Read::emissive_texopt},
    {"map_Pr", &Read::roughness_texname, &Read::roughness_texopt},
    {"map_Pm", &Read::metallic_texname, &Read::metallic_texopt},
    {"map_Ps", &Read::sheen_texname, &Read::sheen_texopt},
    {"map_d", &Read::alpha_texname, &Read::alpha_texopt},
    {"bump", &Read::bump_texname, &Read::bump_texopt},
    {"norm", &Read::normal_texname, &Read::normal_texopt},
};

void take(const std::string& name, const tinyobj::texture_option_t& options, MtlMap& map)
{
    map.name = name;
    map.scale = {single(options.scale[0]), single(options.scale[1])};
    map.offset = {single(options.origin_offset[0]), single(options.origin_offset[1])};
    map.strength = single(options.bump_multiplier);
}

}  // namespace

ObjContent read_obj_text(const std::string& file, std::string_view text, Losses& losses)
{
    ObjLines lines(file, text, losses);
    ObjBuilder to(lines);
    std::istream stream(&lines);
    stream.exceptions(std::ios::badbit);  // lets the SceneErrors of the lines through
    tinyobj::LoadObjWithCallback(stream, callbacks(), &to);
    return to.finish();
}

void read_mtl_text(const std::string& text, MtlMaterial& material)
{
    std::istringstream stream(text);
    std::map<std::string, int> places;
    std::vector<Read> all;  // one: the package keeps 3 kB for each
    std::string warnings, errors;
    tinyobj::LoadMtl(&places, &all, &stream, &warnings, &errors);
    const Read& read = all.back();
    material.opacity = single(read.dissolve);
    material.illum = read.illum;
    for (const ColourField& f : kColourFields) {
        const auto& c = read.*f.colour;
        if (material.has(f.keyword)) material.numbers[f.keyword] = {single(c[0]), single(c[1]), single(c[2])};
    }
    for (const NumberField& f : kNumbers)
        if (material.has(f.keyword)) material.numbers[f.keyword] = grey(single(read.*f.number));
    // The package keeps the text of a word that it does not know: one number, or a colour.
    for (const auto& [keyword, numbers] : read.unknown_parameter) {
        double c[3] = {};
        size_t count = 0;
        for (const std::string_view word : words(numbers))
            if (count < 3) parse_finite(word, c[count++]);
        if (material.has(keyword.c_str()))
            material.numbers[keyword] = count == 3 ? Rgb{single(c[0]), single(c[1]), single(c[2])} : grey(single(c[0]));
    }
    for (const MapField& f : kMapFields)
        if (material.map(f.keyword)) take(read.*f.name, read.*f.options, material.maps[f.keyword]);
}

// The package adds up decimals, and takes an exponent in an int and then to the power of 5. In 1e2147483648 the int
// overflows, and 0e999 is 0 times infinity. So words that are long or have an exponent are written anew.
void append_number(std::string& text, std::string_view word, double value)
{
    constexpr size_t kLongest = 24;
    text += ' ';
    if (word.size() <= kLongest && word.find_first_of("eE") == std::string_view::npos) {
        text += word;
        return;
    }
    char digits[32];
    text.append(digits, std::to_chars(std::begin(digits), std::end(digits), value).ptr);
}

}  // namespace lumi::baker
