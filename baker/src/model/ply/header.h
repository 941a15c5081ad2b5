// SPDX-License-Identifier: MIT
// The heading of PLY files: which elements follow, and how their numbers are written.
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
    PlyType count_type = PlyType::uint8;  // of the list's length, which stands before the list
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
};

// Throws SceneError.
PlyHeader read_ply_header(const std::filesystem::path& file, std::string_view bytes);

}  // namespace lumi::baker
