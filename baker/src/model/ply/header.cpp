// SPDX-License-Identifier: MIT
#include "model/ply/header.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "lumi/baker/scene.h"
#include "util/text_lines.h"

namespace lumi::baker
{

namespace
{

constexpr std::string_view kBlanks = " \t\r\n\v\f";

template <class T>
double value_in(const char* bytes)
{
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

double value_of(PlyType type, const char* bytes)
{
    switch (type) {
        case PlyType::int8:
            return value_in<int8_t>(bytes);
        case PlyType::uint8:
            return value_in<uint8_t>(bytes);
        case PlyType::int16:
            return value_in<int16_t>(bytes);
        case PlyType::uint16:
            return value_in<uint16_t>(bytes);
        case PlyType::int32:
            return value_in<int32_t>(bytes);
        case PlyType::uint32:
            return value_in<uint32_t>(bytes);
        case PlyType::float32:
            return value_in<float>(bytes);
        case PlyType::float64:
            break;
    }
    return value_in<double>(bytes);
}

bool machine_is_big_endian()
{
    const uint16_t one = 1;
    char first = 0;
    std::memcpy(&first, &one, 1);
    return first == 0;
}

}  // namespace

PlyNumbers::PlyNumbers(const std::filesystem::path& file, const PlyHeader& header, std::string_view bytes)
    : file_(file.string()),
      rest_(bytes.substr(header.end)),
      text_(header.format == PlyFormat::text),
      swapped_((header.format == PlyFormat::big_endian) != machine_is_big_endian()),
      line_(header.lines + 1)
{
}

void PlyNumbers::fail(const std::string& text) const
{
    throw SceneError(at({file_, text_ ? line_ : 0}, text));
}

double PlyNumbers::next_word(PlyType type)
{
    const size_t begin = std::min(rest_.find_first_not_of(kBlanks), rest_.size());
    line_ += static_cast<uint32_t>(std::count(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
    rest_.remove_prefix(begin);
    if (rest_.empty()) fail("the file is cut short; copy or export it again");
    const size_t end = std::min(rest_.find_first_of(kBlanks), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    double value = 0;
    const bool finite = parse_finite(word, value);
    if (type >= PlyType::float32 && !finite) return std::numeric_limits<double>::quiet_NaN();
    if (!finite || (type < PlyType::float32 && value != std::floor(value)))
        fail("'" + std::string(word) + "' is no whole number; export it again");
    return value;
}

double PlyNumbers::next(PlyType type)
{
    if (text_) return next_word(type);
    const size_t size = bytes_of(type);
    if (rest_.size() < size) fail("the file is cut short; copy or export it again");
    char bytes[sizeof(double)] = {};
    std::copy_n(rest_.data(), size, bytes);
    if (swapped_) std::reverse(bytes, bytes + size);
    rest_.remove_prefix(size);
    return value_of(type, bytes);
}

bool PlyNumbers::skip_line()
{
    if (!text_) return false;
    const size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    const std::string_view surplus = rest_.substr(0, end);
    if (surplus.find_first_not_of(kBlanks) == std::string_view::npos) return false;
    rest_.remove_prefix(end);
    return true;
}

void PlyNumbers::require_bytes(double bytes, const std::string& what) const
{
    if (bytes <= static_cast<double>(rest_.size())) return;
    fail("it says that " + what + ", which take at least " + number_text(bytes) + " bytes, but " +
         std::to_string(rest_.size()) + " are left; the file is cut short, copy or export it again");
}

void PlyNumbers::require(const PlyElement& element) const
{
    double row = 0;
    for (const PlyProperty& p : element.properties)
        row += text_ ? 2.0 : static_cast<double>(bytes_of(p.is_list ? p.count_type : p.type));
    // A text may end without the blank behind its last number.
    const double all = row * static_cast<double>(element.count) - (text_ && element.count != 0 ? 1 : 0);
    require_bytes(all, "elements '" + element.name + "' are " + std::to_string(element.count));
}

void PlyNumbers::require(uint64_t numbers, PlyType type) const
{
    require_bytes(static_cast<double>(numbers) * (text_ ? 2.0 : static_cast<double>(bytes_of(type))),
                  std::to_string(numbers) + " numbers follow in a list");
}

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
        if (line.empty() || line[0] == "obj_info") return;
        if (line[0] == "comment") return take_comment(line);
        if (line[0] == "format" && line.size() == 3) return take_format(line);
        if (line[0] == "element" && line.size() == 3) return take_element(line);
        if (line[0] == "property" && (line.size() == 3 || (line.size() == 5 && line[1] == "list")))
            return take_property(line);
        ++header_.strange_lines;
    }

    void take_comment(const std::vector<std::string_view>& line)
    {
        if (line.size() >= 3 && line[1] == "TextureFile") header_.picture = std::string(line[2].substr(0, 60));
        // "Created by Blender 3.4.1 - ..." and "Created in Blender version 4.0.0"
        if (line.size() >= 4 && line[1] == "Created" && line[3] == "Blender") header_.by_blender = true;
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
