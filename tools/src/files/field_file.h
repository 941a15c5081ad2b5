// SPDX-License-Identifier: MIT
// A field of either kind in a memory-mapped file, opened by the very readers that firmware links.
#pragma once

#include <string>
#include <vector>

#include "lumi/field.h"
#include "lumi/guided/guided_field.h"
#include "lumi/host/mapped_file.h"

namespace lumi::tools
{

// One entry of the file's section table.
struct Section {
    std::string type;  // four characters
    bool required;
    uint32_t offset, bytes, crc32;
};

// What people call a section of this type: "mean colour"; an unknown type in quotes.
std::string title_of(const std::string& type);

class FieldFile
{
public:
    // Maps and opens; checks no section's bytes. Throws Failure with the cause and its mend.
    explicit FieldFile(const std::string& path);

    const std::string& path() const { return path_; }
    bool is_guided() const { return is_guided_; }
    // Precondition: the kind that the file holds.
    const Field& field() const { return field_; }
    const GuidedField& guided() const { return guided_; }
    // Throws Failure for a guided field, saying that `task` is about chord fields.
    const Field& require_chord(const std::string& task) const;
    const uint8_t* bytes() const { return file_.bytes(); }
    size_t size() const { return file_.size(); }

    std::vector<Section> sections() const;

    // Whether the section's bytes still have their CRC. Cost: reads them all.
    bool is_intact(const Section& section) const;

    // Throws Failure naming the first damaged section.
    void require_intact() const;

private:
    std::string path_;
    host::MappedFile file_;
    bool is_guided_ = false;
    Field field_;
    GuidedField guided_;
};

// "rgb888", "rgb565", "palette8" or "luma8".
const char* name_of(format::TexelFormat format);
// "none", "index4", "index8" or "vq8"; "proxy" or "focus"; "rgb565" or "palette8".
const char* name_of(format::GuidedTexel texel);
const char* name_of(format::GuidedSurface surface);
const char* name_of(format::MeanFormat format);

}  // namespace lumi::tools
