// SPDX-License-Identifier: MIT
// A field of either kind, read from a file and opened by the very readers that firmware links.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lumi/chord/field.h"
#include "lumi/surface/frame.h"

namespace lumi::tools
{

// Holds one entry of the file's section table.
struct Section {
    std::string type;  // four characters
    bool required;
    uint32_t offset, bytes, crc32;
};

// Describes the sphere around the scene in the scene's units and axes.
struct FieldSphere {
    std::array<float, 3> centre;
    float radius;
};

// Returns what people call a section of this type: "view table"; an unknown type in quotes.
std::string title_of(const std::string& type);

class FieldFile
{
public:
    enum class Role { input, own_output };

    // Reads and opens; checks no section's bytes. Throws Failure with the cause and its mend. An input may not be
    // written by the same command (lumi/baker/file_guard.h); what the command has written itself may be.
    explicit FieldFile(const std::string& path, Role role = Role::input);

    const std::string& path() const { return path_; }
    bool is_surface() const { return is_surface_; }
    // Precondition: the kind that the file holds.
    const Field& field() const { return field_; }
    const SurfaceField& surface() const { return surface_; }
    const uint8_t* bytes() const { return bytes_.data(); }
    size_t size() const { return bytes_.size(); }

    FieldSphere sphere() const;
    std::vector<Section> sections() const;

    // Whether the section's bytes still have their CRC. Cost: reads them all.
    bool is_intact(const Section& section) const;

    // Throws Failure naming the first damaged section.
    void require_intact() const;

private:
    std::string path_;
    std::vector<uint8_t> bytes_;  // those of the file may change meanwhile
    bool is_surface_ = false;
    Field field_;
    SurfaceField surface_;
};

}  // namespace lumi::tools
