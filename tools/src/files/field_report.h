// SPDX-License-Identifier: MIT
// What `lumi inspect` says about a field file.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "files/field_file.h"

namespace lumi::tools
{

struct FieldReport {
    struct Entry {
        Section section;
        std::optional<bool> intact;  // unset: not checked
    };
    std::string path;
    uint64_t file_bytes = 0;
    uint32_t version = 0;
    std::string layout;  // "chord" or "surface"
    uint32_t origins = 0, directions = 0, used_origins = 0;
    uint32_t row_bytes = 0, row_stride_bytes = 0;
    std::string texel_format, colour_space;
    std::optional<SurfaceField> surface;
    std::array<float, 3> centre = {};  // scene units, scene axes
    float radius = 0;
    std::string view;  // core's type that draws it
    std::vector<Entry> sections;
    uint64_t other_bytes = 0;  // header, table and alignment
};

uint32_t triangles_of(const SurfaceField& field);

// Reads every section's bytes if `verify`.
FieldReport describe_field(const FieldFile& file, bool verify);

// For people, and for programs; both end with a line break.
std::string text_of(const FieldReport& report);
std::string json_of(const FieldReport& report);

}  // namespace lumi::tools
