// SPDX-License-Identifier: MIT
#include "model/obj_text.h"

#include "lumi/baker/scene.h"
#include "model/positions.h"

namespace lumi::baker
{
namespace
{

constexpr size_t kMaxCorners = 255;  // the parser counts a face's corners in 8 bits

class ObjPreparation
{
public:
    explicit ObjPreparation(const std::string& file) : file_(file) { out_.text = "mtllib all\n"; }

    void take(const Line& line)
    {
        if (line.keyword == "v") {
            take_numbers(line, 3, 3, positions_);
        } else if (line.keyword == "vn") {
            take_numbers(line, 3, 3, normals_);
        } else if (line.keyword == "vt") {
            take_numbers(line, 1, 2, uvs_);
        } else if (line.keyword == "f") {
            take_face(line);
        } else if (line.keyword == "usemtl") {
            take_use(line);
        } else if (line.keyword == "mtllib") {
            out_.libraries.push_back({line.argument, line.number});
        } else if (line.keyword == "s") {
            out_.smoothing = out_.smoothing || (line.argument != "off" && line.argument != "0");
            copy(line);
        }
        // Groups, lines, points, curves: nothing that a path tracer draws.
    }

    ObjText finish()
    {
        if (out_.face_lines.empty())
            throw SceneError(at({file_}, "there is no face ('f' line) in it; export the scene as polygons"));
        return std::move(out_);
    }

private:
    Place place(const Line& line) const { return {file_, line.number}; }

    void copy(const Line& line) { out_.text += line.keyword + " " + line.argument + "\n"; }

    void take_numbers(const Line& line, size_t least, size_t most, int64_t& count)
    {
        require_numbers(place(line), line, least, most, kMaxCoordinate);
        out_.text += line.keyword;
        const std::vector<std::string_view> list = words(line.argument);
        for (size_t k = 0; k < std::min(list.size(), most); ++k) out_.text += " " + std::string(list[k]);
        out_.text += "\n";
        ++count;
    }

    void take_face(const Line& line)
    {
        const std::vector<std::string_view> corners = words(line.argument);
        if (corners.size() < 3) {
            throw SceneError(at(place(line), "a face of " + std::to_string(corners.size()) +
                                                 " corners; remove the line or give it at least 3"));
        }
        if (corners.size() > kMaxCorners) {
            throw SceneError(at(place(line), "a face of " + std::to_string(corners.size()) + " corners, at most " +
                                                 std::to_string(kMaxCorners) + " work; export triangles"));
        }
        for (const std::string_view corner : corners) check_corner(line, corner);
        out_.face_lines.push_back(line.number);
        copy(line);
    }

    // "v", "v/t", "v//n" or "v/t/n".
    void check_corner(const Line& line, std::string_view corner) const
    {
        const int64_t counts[3] = {positions_, uvs_, normals_};
        static constexpr const char* kNames[3] = {"vertex", "texture coordinate", "normal"};
        std::string_view rest = corner;
        for (size_t k = 0; k < 3; ++k) {
            const size_t end = std::min(rest.find('/'), rest.size());
            const std::string_view number = rest.substr(0, end);
            const bool last = end == rest.size();
            if (!number.empty() || last || k == 0) check_index(line, number, kNames[k], counts[k]);
            if (last) return;
            rest.remove_prefix(end + 1);
        }
        throw SceneError(
            at(place(line), "the corner '" + std::string(corner) + "' has more than three parts; write v/t/n"));
    }

    void check_index(const Line& line, std::string_view number, const char* name, int64_t count) const
    {
        int64_t index = 0;
        if (!parse_integer(number, index)) {
            throw SceneError(
                at(place(line), "'" + std::string(number) + "' is no " + name + " number; export the file again"));
        }
        if (index == 0 || index > count || index < -count) {
            throw SceneError(at(place(line), "the face uses " + std::string(name) + " " + std::to_string(index) +
                                                 ", but " + std::to_string(count) +
                                                 " come before it; the file is damaged or cut short, export it again"));
        }
    }

    void take_use(const Line& line)
    {
        const auto [entry, fresh] = indices_.try_emplace(line.argument, out_.materials.size());
        if (fresh) out_.materials.push_back({line.argument, line.number});
        out_.text += "usemtl " + stand_in_name(entry->second) + "\n";
    }

    std::string file_;
    ObjText out_;
    std::map<std::string, size_t> indices_;
    int64_t positions_ = 0, normals_ = 0, uvs_ = 0;
};

}  // namespace

std::string stand_in_name(size_t k)
{
    return "m" + std::to_string(k);
}

ObjText prepare_obj(const std::string& file, std::string_view text)
{
    if (text.find('\0') != std::string_view::npos)
        throw SceneError(at({file}, "this is no text; name a Wavefront OBJ file, or export .glb"));
    ObjPreparation preparation(file);
    for (const Line& line : split_lines(text)) preparation.take(line);
    return preparation.finish();
}

}  // namespace lumi::baker
