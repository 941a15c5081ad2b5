// SPDX-License-Identifier: MIT
#include "model/ply/header.h"

#include <algorithm>

#include "lumi/baker/scene.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

struct TypeName {
    std::string_view old_name, new_name;
    size_t bytes;
};
// In the order of PlyType.
constexpr TypeName kTypes[] = {{"char", "int8", 1},     {"uchar", "uint8", 1},   {"short", "int16", 2},
                               {"ushort", "uint16", 2}, {"int", "int32", 4},     {"uint", "uint32", 4},
                               {"float", "float32", 4}, {"double", "float64", 8}};
constexpr std::string_view kFormats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
constexpr size_t kMaxProperties = 1000;

class HeaderReader
{
public:
    HeaderReader(const std::filesystem::path& file, std::string_view bytes) : file_(file.string()), bytes_(bytes) {}

    PlyHeader read()
    {
        std::vector<std::string_view> line = next_line();
        if (line.size() != 1 || line[0] != "ply") fail("this is no PLY file; export it again");
        for (line = next_line(); line.size() != 1 || line[0] != "end_header"; line = next_line()) take(line);
        if (!has_format_) fail("the heading names no 'format'; export it again");
        header_.end = at_;
        header_.lines = line_;
        return std::move(header_);
    }

private:
    [[noreturn]] void fail(const std::string& text) const { throw SceneError(at({file_, line_}, text)); }

    std::vector<std::string_view> next_line()
    {
        ++line_;
        const size_t end = bytes_.find('\n', at_);
        if (end == std::string_view::npos) fail("the heading has no end, the file is cut short; export it again");
        std::string_view line = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        return words(line);
    }

    void take(const std::vector<std::string_view>& line)
    {
        if (line.empty() || line[0] == "comment" || line[0] == "obj_info") return;
        if (line[0] == "format" && line.size() == 3) return take_format(line);
        if (line[0] == "element" && line.size() == 3) return take_element(line);
        if (line[0] == "property" && (line.size() == 3 || (line.size() == 5 && line[1] == "list")))
            return take_property(line);
        ++header_.strange_lines;
    }

    void take_format(const std::vector<std::string_view>& line)
    {
        const auto* found = std::find(std::begin(kFormats), std::end(kFormats), line[1]);
        if (found == std::end(kFormats) || line[2] != "1.0")
            fail("the format " + std::string(line[1]) + " " + std::string(line[2]) +
                 " is not read; export it as PLY 1.0");
        header_.format = static_cast<PlyFormat>(found - std::begin(kFormats));
        has_format_ = true;
    }

    void take_element(const std::vector<std::string_view>& line)
    {
        int64_t count = 0;
        if (!parse_integer(line[2], count) || count < 0)
            fail("'" + std::string(line[2]) + "' is no number of elements; export it again");
        header_.elements.push_back({std::string(line[1]), static_cast<uint64_t>(count), {}});
    }

    void take_property(const std::vector<std::string_view>& line)
    {
        if (header_.elements.empty()) fail("a property comes before the first element; export it again");
        std::vector<PlyProperty>& list = header_.elements.back().properties;
        if (list.size() >= kMaxProperties) fail("an element has too many properties; export it with fewer");
        const bool is_list = line.size() == 5;
        PlyProperty property = {std::string(line.back()), type_of(line[is_list ? 3 : 1]), is_list};
        if (is_list) property.count_type = type_of(line[2]);
        if (property.count_type > PlyType::uint32) fail("the length of a list must be a whole number; export it again");
        list.push_back(std::move(property));
    }

    PlyType type_of(std::string_view name) const
    {
        const auto* found = std::find_if(std::begin(kTypes), std::end(kTypes),
                                         [&](const TypeName& t) { return name == t.old_name || name == t.new_name; });
        if (found == std::end(kTypes)) fail("'" + std::string(name) + "' is no type of numbers; export it again");
        return static_cast<PlyType>(found - std::begin(kTypes));
    }

    std::string file_;
    std::string_view bytes_;
    size_t at_ = 0;
    uint32_t line_ = 0;
    bool has_format_ = false;
    PlyHeader header_;
};

}  // namespace

size_t bytes_of(PlyType type)
{
    return kTypes[static_cast<size_t>(type)].bytes;
}

const PlyProperty* PlyElement::find(std::string_view property) const
{
    const auto found =
        std::find_if(properties.begin(), properties.end(), [&](const PlyProperty& p) { return p.name == property; });
    return found == properties.end() ? nullptr : &*found;
}

PlyHeader read_ply_header(const std::filesystem::path& file, std::string_view bytes)
{
    return HeaderReader(file, bytes).read();
}

}  // namespace lumi::baker
