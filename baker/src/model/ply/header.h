// SPDX-License-Identifier: MIT
// Reads PLY files: the heading, which tells what elements follow and how numbers are written, and then the numbers.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lumi::baker
{

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyFormat { text, little_endian, big_endian };

size_t bytes_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;
    bool is_list = false;
    PlyType count_type = PlyType::uint8;  // the list's length has it, which stands before the list
};

struct PlyElement {
    std::string name;
    uint64_t count = 0;
    std::vector<PlyProperty> properties;

    // Null if there is none.
    const PlyProperty* find(std::string_view property) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::text;
    std::vector<PlyElement> elements;
    size_t end = 0;            // where the first element begins
    uint32_t lines = 0;        // before it
    size_t strange_lines = 0;  // which say nothing that we know
    std::string picture;       // that a comment names, as MeshLab writes it
    bool by_blender = false;   // whose axis upwards is z
};

// Throws SceneError.
PlyHeader read_ply_header(const std::filesystem::path& file, std::string_view bytes);

// Reads the numbers of a PLY file, one after the other.
class PlyNumbers
{
public:
    // Begins behind the heading. `bytes` must live as long.
    PlyNumbers(const std::filesystem::path& file, const PlyHeader& header, std::string_view bytes);

    // Throws SceneError where the file ends, or holds what is no number of that type. Floats may be infinite or none.
    double next(PlyType type);
    // In a text: passes over what stands on the line behind an element's last number. Returns whether there was any.
    bool skip_line();
    // Throws SceneError where the file is too short for so many elements, or for so many numbers.
    void require(const PlyElement& element) const;
    void require(uint64_t numbers, PlyType type) const;

    // Whether all is read and no line end follows: then nobody can tell whether the last number is whole.
    bool ends_in_a_number() const { return text_ && rest_.empty(); }
    // For messages: where the next number stands.
    [[noreturn]] void fail(const std::string& text) const;

private:
    double next_word(PlyType type);
    void require_bytes(double bytes, const std::string& what) const;

    std::string file_;
    std::string_view rest_;
    bool text_, swapped_;
    uint32_t line_;
};

}  // namespace lumi::baker
