// SPDX-License-Identifier: MIT
#include "model/obj_lines.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "lumi/baker/scene.h"
#include "model/tiny_obj.h"
#include "model/vertices.h"

namespace lumi::baker
{
namespace
{

// Words of elements that have no surface, and words that change nothing in a picture.
constexpr const char* kFreeForms[] = {"curv", "curv2", "surf"};
constexpr const char* kSilent[] = {"vp",       "cstype",   "deg", "bmat",       "step",  "parm",  "trim",
                                   "hole",     "scrv",     "sp",  "end",        "con",   "mg",    "bevel",
                                   "c_interp", "d_interp", "lod", "shadow_obj", "ctech", "stech", "usemap",
                                   "maplib",   "call",     "csh", "trace_obj"};
constexpr const char* kDrawn[] = {"v", "vn", "vt", "f", "fo", "s", "usemtl", "mtllib", "l", "p", "o", "g"};

// The parts of a corner, "v/t/n", as counts_ has them.
enum Part : size_t { kPosition, kUv, kNormal };
constexpr const char* kPartNames[] = {"vertex", "texture coordinate", "normal"};

template <size_t Size>
bool is_among(const char* const (&list)[Size], const std::string& word)
{
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

bool is_known(const std::string& word)
{
    return is_among(kDrawn, word) || is_among(kSilent, word) || is_among(kFreeForms, word);
}

}  // namespace

void fail_beyond(const Place& place, const char* name, int64_t index, size_t count)
{
    throw SceneError(at(place, "the face uses " + std::string(name) + " " + std::to_string(index) + ", but there are " +
                                   std::to_string(count) + "; the file is damaged or cut short, export it again"));
}

ObjLines::ObjLines(const std::string& file, std::string_view text, Losses& losses)
    : file_(file), losses_(losses), lines_(text)
{
    if (text.find('\0') != std::string_view::npos)
        throw SceneError(at({file}, "this is no text; name a Wavefront OBJ file, or export .glb"));
}

ObjLines::int_type ObjLines::underflow()
{
    while (lines_.next(line_)) {
        if (!take()) continue;
        out_ += '\n';
        setg(out_.data(), out_.data(), out_.data() + out_.size());
        return traits_type::to_int_type(out_.front());
    }
    if (!has_faces_) fail_without_faces();
    return traits_type::eof();
}

// Each of these writes out_ and says whether the package gets it.
bool ObjLines::take()
{
    if (!is_known(line_.keyword) && is_known(in_small_letters(line_.keyword))) {
        leave_out("line(s) begin with capital letters, and are read as if they did not; export again");
        line_.keyword = in_small_letters(line_.keyword);
    }
    out_ = line_.keyword;
    if (line_.keyword == "v") return take_position();
    if (line_.keyword == "f" || line_.keyword == "fo") return take_face();
    if (line_.keyword == "vn") {
        ++counts_[kNormal];
        return take_numbers(3, 3);
    }
    if (line_.keyword == "vt") {
        ++counts_[kUv];
        return take_numbers(1, 2);
    }
    return take_other();
}

bool ObjLines::take_other()
{
    if (line_.keyword == "usemtl" || line_.keyword == "o" || line_.keyword == "g") {
        out_ += ' ' + line_.argument;
        return true;
    }
    if (line_.keyword == "mtllib")  // the package would divide names at their blanks
        libraries.push_back({line_.argument, line_.number});
    else if (line_.keyword == "s")
        take_smoothing();
    else if (line_.keyword == "l" || line_.keyword == "p")
        has_lines_ =
            leave_out("line(s) and point(s) have no surface and are not drawn; give them a thickness, as meshes");
    else if (is_among(kFreeForms, line_.keyword))
        has_free_forms_ = leave_out("free-form curve(s) and surface(s) are not drawn; convert them to meshes");
    else if (!is_among(kSilent, line_.keyword))
        leave_out("line(s) begin with '" + line_.keyword +
                  "', which is no word of OBJ, and are left out; check the file");
    return false;
}

// Three numbers; then a weight, a colour, or both.
bool ObjLines::take_position()
{
    ++counts_[kPosition];
    take_colour();
    return take_numbers(3, 3);
}

bool ObjLines::take_numbers(size_t least, size_t most)
{
    std::string_view rest = line_.argument;
    for (const double value : numbers_of(place(), line_, least, most, kMaxCoordinate))
        append_number(out_, take_word(rest), value);
    return true;
}

void ObjLines::take_colour()
{
    colour_.reset();
    constexpr size_t kWithColour = 6;
    const std::vector<std::string_view> list = words(line_.argument);
    if (list.size() < kWithColour) return;
    const std::string_view* first = &list[list.size() == kWithColour ? 3 : 4];
    double c[3] = {};
    for (size_t k = 0; k < 3; ++k)
        if (!parse_finite(first[k], c[k])) return;
    const auto part = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 255.0)); };
    colour_ = Rgb{part(c[0]), part(c[1]), part(c[2])};
}

bool ObjLines::take_face()
{
    const std::vector<std::string_view> corners = words(line_.argument);
    if (corners.size() < 3) {
        leave_out("face(s) have fewer than three corners and are left out; delete loose edges");
        return false;
    }
    out_ = "f";
    for (std::string_view corner : corners) {
        check_corner(corner);
        while (corner.back() == '/') corner.remove_suffix(1);
        out_ += ' ';
        out_ += corner;
    }
    return has_faces_ = true;
}

// "v", "v/t", "v//n" or "v/t/n"; numbers at the end may be missing behind their slashes.
void ObjLines::check_corner(std::string_view corner) const
{
    std::string_view rest = corner;
    for (size_t k = 0; k < std::size(counts_); ++k) {
        const size_t end = std::min(rest.find('/'), rest.size());
        const std::string_view number = rest.substr(0, end);
        const bool last = end == rest.size();
        if (!number.empty() || k == 0) check_index(number, k);
        if (last) return;
        rest.remove_prefix(end + 1);
    }
    throw SceneError(at(place(), "the corner '" + std::string(corner) + "' has more than three parts; write v/t/n"));
}

// An index beyond `counts_` is sound so far: its element may still come.
void ObjLines::check_index(std::string_view number, size_t part) const
{
    int64_t index = 0;
    if (!parse_integer(number, index)) {
        throw SceneError(
            at(place(), "'" + std::string(number) + "' is no " + kPartNames[part] + " number; export the file again"));
    }
    const bool is_before = index < 0 && static_cast<uint64_t>(-(index + 1)) >= counts_[part];
    if (index == 0 || is_before || index > std::numeric_limits<int32_t>::max())
        fail_beyond(place(), kPartNames[part], index, counts_[part]);
}

void ObjLines::take_smoothing()
{
    int64_t group = line_.argument == "on" ? 1 : 0;
    parse_integer(line_.argument, group);
    smoothing_ = static_cast<uint32_t>(std::clamp<int64_t>(group, 0, std::numeric_limits<int32_t>::max()));
}

// True, for brevity.
bool ObjLines::leave_out(const std::string& kind)
{
    losses_.add_at(line_.number, kind);
    return true;
}

void ObjLines::fail_without_faces() const
{
    const char* text = "there is no face ('f' line) in it; export the scene as polygons";
    if (has_lines_)
        text = "there are only lines and points in it, which have no surface; give them a thickness, as meshes";
    if (has_free_forms_)
        text = "there are only free-form curves and surfaces in it, which are not read; convert them to meshes";
    throw SceneError(at({file_}, text));
}

}  // namespace lumi::baker
