// SPDX-License-Identifier: MIT
#include "files/field_file.h"

#include <cstring>
#include <map>

#include "lumi/baker/file_guard.h"
#include "lumi/detail/crc32.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

const char* mend_of(FieldError error)
{
    switch (error) {
        case FieldError::bad_magic:
            return "give a field file that `lumi bake` wrote";
        case FieldError::unsupported_version:
        case FieldError::unknown_required:
            return "use a newer lumi, or bake the scene again with this one";
        case FieldError::truncated:
        case FieldError::trailing_bytes:
        case FieldError::header_crc:
        case FieldError::table_crc:
        case FieldError::section_crc:
            return "copy the file again or bake it again";
        default:
            return "bake it again";
    }
}

uint32_t read_u32(const uint8_t* bytes)
{
    return static_cast<uint32_t>(bytes[0]) | static_cast<uint32_t>(bytes[1]) << 8 |
           static_cast<uint32_t>(bytes[2]) << 16 | static_cast<uint32_t>(bytes[3]) << 24;
}

}  // namespace

std::string title_of(const std::string& type)
{
    static const std::map<std::string, std::string> titles = {
        {"TEXL", "texel"}, {"LAYO", "layout"},    {"PALT", "palette"}, {"SURF", "surface"}, {"SVTX", "vertex"},
        {"SPAT", "patch"}, {"SNEI", "neighbour"}, {"STEX", "texel"},   {"SPAL", "palette"}, {"SVIE", "view table"}};
    const auto title = titles.find(type);
    return title != titles.end() ? title->second : "\"" + type + "\"";
}

FieldFile::FieldFile(const std::string& path, Role role) : path_(path)
{
    if (role == Role::input) baker::note_input(path);
    if (const int error = file_.open(path); error != 0)
        throw Failure(path, std::string("cannot be read (") + std::strerror(error) + ")", "check the path");
    watch_ = std::make_unique<CutShortWatch>(path, file_.bytes(), file_.size());
    FieldError error = open_field(file_.bytes(), file_.size(), field_);
    is_surface_ = error == FieldError::surface_field;
    if (is_surface_) error = open_surface(file_.bytes(), file_.size(), surface_);
    if (error != FieldError::none) throw Failure(path, describe(error), mend_of(error));
}

std::vector<Section> FieldFile::sections() const
{
    const uint8_t* bytes = file_.bytes();
    const uint32_t count = read_u32(bytes + detail::format::header::kSectionCountAt) & 0xFFFF;
    std::vector<Section> sections;
    for (uint32_t i = 0; i < count; ++i) {
        const uint8_t* entry = bytes + detail::format::kHeaderBytes + i * detail::format::kEntryBytes;
        Section section;
        section.type.assign(reinterpret_cast<const char*>(entry + detail::format::entry::kTypeAt), sizeof(uint32_t));
        section.required = (read_u32(entry + detail::format::entry::kFlagsAt) & detail::format::kRequired) != 0;
        section.offset = read_u32(entry + detail::format::entry::kOffsetAt);
        section.bytes = read_u32(entry + detail::format::entry::kSizeAt);
        section.crc32 = read_u32(entry + detail::format::entry::kCrcAt);
        sections.push_back(section);
    }
    return sections;
}

bool FieldFile::is_intact(const Section& section) const
{
    return lumi::detail::crc32(0, file_.bytes() + section.offset, section.bytes) == section.crc32;
}

void FieldFile::require_intact() const
{
    for (const Section& section : sections())
        if (!is_intact(section))
            throw Failure(path_, "the " + title_of(section.type) + " section's bytes are damaged (CRC)",
                          mend_of(FieldError::section_crc));
}

}  // namespace lumi::tools
