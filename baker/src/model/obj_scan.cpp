// SPDX-License-Identifier: MIT
#include "model/obj_scan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "lumi/baker/scene.h"

namespace lumi::baker
{
namespace
{

// What has no surface, and words that change nothing in a picture.
constexpr const char* kFreeForms[] = {"curv", "curv2", "surf"};
constexpr const char* kSilent[] = {"vp",       "cstype",   "deg", "bmat",       "step",  "parm",  "trim",
                                   "hole",     "scrv",     "sp",  "end",        "con",   "mg",    "bevel",
                                   "c_interp", "d_interp", "lod", "shadow_obj", "ctech", "stech", "usemap",
                                   "maplib",   "call",     "csh", "trace_obj"};
constexpr const char* kDrawn[] = {"v", "vn", "vt", "f", "fo", "s", "usemtl", "mtllib", "l", "p", "o", "g"};

template <size_t Size>
bool is_among(const char* const (&list)[Size], const std::string& word)
{
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

bool is_known(const std::string& word)
{
    return is_among(kDrawn, word) || is_among(kSilent, word) || is_among(kFreeForms, word);
}

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

class ObjScan
{
public:
    ObjScan(const std::string& file, Losses& losses) : file_(file), losses_(losses) {}

    void take(Line& line)
    {
        if (!is_known(line.keyword) && is_known(in_small_letters(line.keyword))) {
            losses_.add_at(line.number,
                           "line(s) begin with capital letters, and are read as if they did not; export again");
            line.keyword = in_small_letters(line.keyword);
        }
        if (line.keyword == "v")
            take_position(line);
        else if (line.keyword == "vn")
            take_normal(line);
        else if (line.keyword == "vt")
            take_uv(line);
        else if (line.keyword == "f" || line.keyword == "fo")
            take_face(line);
        else
            take_other(line);
    }

    ObjContent finish()
    {
        if (out_.faces.empty()) fail_without_faces();
        for (const ObjFace& face : out_.faces)
            for (uint32_t k = 0; k < face.count; ++k) check(face, out_.corners[face.first + k]);
        end_part(object_);
        end_part(group_);
        finish_colours();
        return std::move(out_);
    }

private:
    Place place(const Line& line) const { return {file_, line.number}; }

    [[noreturn]] void fail_without_faces() const
    {
        const char* text = "there is no face ('f' line) in it; export the scene as polygons";
        if (has_lines_)
            text = "there are only lines and points in it, which have no surface; give them a thickness, as meshes";
        if (has_free_forms_)
            text = "there are only free-form curves and surfaces in it, which are not read; convert them to meshes";
        throw SceneError(at({file_}, text));
    }

    void take_other(const Line& line)
    {
        if (line.keyword == "usemtl") {
            take_use(line);
        } else if (line.keyword == "mtllib") {
            out_.libraries.push_back({line.argument, line.number});
        } else if (line.keyword == "s") {
            take_smoothing(line);
        } else if (line.keyword == "o" || line.keyword == "g") {
            take_part(line);
        } else if (line.keyword == "l" || line.keyword == "p") {
            has_lines_ = true;
            losses_.add_at(line.number,
                           "line(s) and point(s) have no surface and are not drawn; give them a thickness, as meshes");
        } else if (is_among(kFreeForms, line.keyword)) {
            has_free_forms_ = true;
            losses_.add_at(line.number, "free-form curve(s) and surface(s) are not drawn; convert them to meshes");
        } else if (!is_among(kSilent, line.keyword)) {
            losses_.add_at(line.number, "line(s) begin with '" + line.keyword +
                                            "', which is no word of OBJ, and are left out; check the file");
        }
    }

    // Three numbers; then a weight, a colour, or both.
    void take_position(const Line& line)
    {
        const std::vector<double> p = numbers_of(place(line), line, 3, 3, kMaxCoordinate);
        const std::vector<std::string_view> list = words(line.argument);
        constexpr size_t kWithColour = 6;
        if (list.size() >= kWithColour) take_colour(&list[list.size() == kWithColour ? 3 : 4]);
        out_.positions.push_back({p[0], p[1], p[2]});
    }

    void take_colour(const std::string_view* list)
    {
        double c[3] = {};
        for (size_t k = 0; k < 3; ++k)
            if (!parse_finite(list[k], c[k])) return;
        const auto part = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 255.0)); };
        out_.colours.resize(out_.positions.size(), grey(-1));
        out_.colours.push_back(Rgb{part(c[0]), part(c[1]), part(c[2])});
    }

    // Of some programs they run to 255, of others a little beyond 1. Positions without a colour are white.
    void finish_colours()
    {
        if (out_.colours.empty()) return;
        out_.colours.resize(out_.positions.size(), grey(-1));
        const float scale = are_bytes(out_.colours) ? 1.0f / 255 : 1.0f;
        const auto part = [&](float c) { return std::min(1.0f, scale * c); };
        for (Rgb& c : out_.colours) c = c.r < 0 ? grey(1) : Rgb{part(c.r), part(c.g), part(c.b)};
    }

    void take_normal(const Line& line)
    {
        const std::vector<double> n = numbers_of(place(line), line, 3, 3, kMaxCoordinate);
        out_.normals.push_back({static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])});
    }

    void take_uv(const Line& line)
    {
        const std::vector<double> uv = numbers_of(place(line), line, 1, 2, kMaxCoordinate);
        out_.uvs.push_back({static_cast<float>(uv[0]), uv.size() > 1 ? static_cast<float>(uv[1]) : 0.0f});
    }

    void take_face(const Line& line)
    {
        const std::vector<std::string_view> corners = words(line.argument);
        if (corners.size() < 3) {
            losses_.add_at(line.number, "face(s) have fewer than three corners and are left out; delete loose edges");
            return;
        }
        const uint32_t first = static_cast<uint32_t>(out_.corners.size());
        for (const std::string_view corner : corners) out_.corners.push_back(corner_of(line, corner));
        out_.faces.push_back({first, static_cast<uint32_t>(corners.size()), material_, smoothing_, line.number});
    }

    // "v", "v/t", "v//n" or "v/t/n".
    ObjCorner corner_of(const Line& line, std::string_view corner) const
    {
        const size_t counts[3] = {out_.positions.size(), out_.uvs.size(), out_.normals.size()};
        static constexpr const char* kNames[3] = {"vertex", "texture coordinate", "normal"};
        int32_t indices[3] = {kNoIndex, kNoIndex, kNoIndex};
        std::string_view rest = corner;
        for (size_t k = 0; k < 3; ++k) {
            const size_t end = std::min(rest.find('/'), rest.size());
            const std::string_view number = rest.substr(0, end);
            const bool last = end == rest.size();
            if (!number.empty() || last || k == 0) indices[k] = index_of(line, number, kNames[k], counts[k]);
            if (last) return {indices[0], indices[2], indices[1]};
            rest.remove_prefix(end + 1);
        }
        throw SceneError(
            at(place(line), "the corner '" + std::string(corner) + "' has more than three parts; write v/t/n"));
    }

    // From 0; a later one may still come.
    int32_t index_of(const Line& line, std::string_view number, const char* name, size_t count) const
    {
        int64_t index = 0;
        if (!parse_integer(number, index)) {
            throw SceneError(
                at(place(line), "'" + std::string(number) + "' is no " + name + " number; export the file again"));
        }
        const int64_t place_of = index < 0 ? static_cast<int64_t>(count) + index : index - 1;
        constexpr int64_t kMost = std::numeric_limits<int32_t>::max();
        if (index == 0 || place_of < 0 || place_of > kMost) fail_beyond(line.number, name, index, count);
        return static_cast<int32_t>(place_of);
    }

    [[noreturn]] void fail_beyond(uint32_t line, const char* name, int64_t index, size_t count) const
    {
        throw SceneError(at({file_, line}, "the face uses " + std::string(name) + " " + std::to_string(index) +
                                               ", but there are " + std::to_string(count) +
                                               "; the file is damaged or cut short, export it again"));
    }

    void check(const ObjFace& face, const ObjCorner& corner) const
    {
        check(face, corner.position, "vertex", out_.positions.size());
        check(face, corner.uv, "texture coordinate", out_.uvs.size());
        check(face, corner.normal, "normal", out_.normals.size());
    }

    void check(const ObjFace& face, int32_t index, const char* name, size_t count) const
    {
        if (index >= 0 && static_cast<size_t>(index) >= count) fail_beyond(face.line, name, int64_t{index} + 1, count);
    }

    void take_smoothing(const Line& line)
    {
        int64_t group = line.argument == "on" ? 1 : 0;
        parse_integer(line.argument, group);
        smoothing_ = static_cast<uint32_t>(std::clamp<int64_t>(group, 0, std::numeric_limits<int32_t>::max()));
    }

    void take_part(const Line& line)
    {
        const bool is_object = line.keyword == "o";
        if (is_object) end_part(object_);
        end_part(group_);
        (is_object ? object_ : group_) = out_.parts.size();
        out_.parts.push_back({line.argument, out_.faces.size(), 0});
    }

    void end_part(std::optional<size_t>& open)
    {
        if (open) out_.parts[*open].end = out_.faces.size();
        open.reset();
    }

    void take_use(const Line& line)
    {
        const auto [entry, fresh] = places_.try_emplace(line.argument, static_cast<int32_t>(out_.materials.size()));
        if (fresh) out_.materials.push_back({line.argument, line.number});
        material_ = entry->second;
    }

    std::string file_;
    Losses& losses_;
    ObjContent out_;
    std::map<std::string, int32_t> places_;  // of materials
    int32_t material_ = kNoIndex;
    uint32_t smoothing_ = 0;
    std::optional<size_t> object_, group_;  // of the parts, what faces belong to
    bool has_lines_ = false, has_free_forms_ = false;
};

}  // namespace

ObjContent scan_obj(const std::string& file, std::string_view text, Losses& losses)
{
    if (text.find('\0') != std::string_view::npos)
        throw SceneError(at({file}, "this is no text; name a Wavefront OBJ file, or export .glb"));
    ObjScan scan(file, losses);
    for_each_line(text, [&](Line& line) { scan.take(line); });
    return scan.finish();
}

}  // namespace lumi::baker
