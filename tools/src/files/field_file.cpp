// SPDX-License-Identifier: MIT
#include "files/field_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
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

// A regular file: a pipe is refused, not waited for.
std::vector<uint8_t> read_whole(const std::string& path)
{
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    const bool is_device = exists(status) && !is_regular_file(status);
    if (is_device && !is_directory(status)) throw Failure(path, "is a device or a pipe", "name a file");
    int error = is_directory(status) ? EISDIR : 0;
    std::vector<uint8_t> bytes;
    if (error == 0) {
        std::ifstream stream(path, std::ios::binary | std::ios::ate);
        error = stream ? 0 : errno;
        bytes.resize(stream ? static_cast<size_t>(stream.tellg()) : 0);
        stream.seekg(0).read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        if (stream.bad()) error = EIO;
        bytes.resize(static_cast<size_t>(stream.gcount()));  // somebody may have cut it meanwhile
    }
    if (error != 0) throw Failure(path, std::string("cannot be read (") + std::strerror(error) + ")", "check the path");
    return bytes;
}

uint32_t read_u32(const uint8_t* bytes)
{
    return static_cast<uint32_t>(bytes[0]) | static_cast<uint32_t>(bytes[1]) << 8 |
           static_cast<uint32_t>(bytes[2]) << 16 | static_cast<uint32_t>(bytes[3]) << 24;
}

float float_from_bits(uint32_t bits)
{
    float value;
    static_assert(sizeof value == sizeof bits, "a field stores IEEE binary32");
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

FieldSphere sphere_of(const SurfaceField& field)
{
    const auto number = [&](size_t k) { return float_from_bits(read_u32(field.sphere + 4 * k)); };
    return {{number(0), number(1), number(2)}, number(3)};
}

FieldSphere sphere_of(const Field& field)
{
    const auto& bits = field.centre_bits;
    return {{float_from_bits(bits[0]), float_from_bits(bits[1]), float_from_bits(bits[2])},
            float_from_bits(field.radius_bits)};
}

}  // namespace

std::string title_of(const std::string& type)
{
    static const std::map<std::string, std::string> titles = {
        {"TEXL", "texel"},       {"LAYO", "layout"},     {"PALT", "palette"},     {"SURF", "surface"},
        {"SVTX", "vertex"},      {"SPAT", "patch"},      {"SNEI", "neighbour"},   {"STEX", "texel"},
        {"SPAL", "palette"},     {"SVIE", "view table"}, {"SSEE", "see-through"}, {"SGLO", "gloss"},
        {"SSTA", "light state"}, {"SPRT", "part"},       {"DRFT", "draft"}};
    const auto title = titles.find(type);
    return title != titles.end() ? title->second : "\"" + type + "\"";
}

FieldFile::FieldFile(const std::string& path, Role role) : path_(path)
{
    if (role == Role::input) baker::note_input(path);
    bytes_ = read_whole(path);
    FieldError error = open_field(bytes(), size(), field_);
    is_surface_ = error == FieldError::surface_field;
    if (is_surface_) error = open_surface<SurfaceFeatures::all>(bytes(), size(), surface_);
    if (error != FieldError::none) throw Failure(path, describe(error), mend_of(error));
}

FieldSphere FieldFile::sphere() const
{
    return is_surface_ ? sphere_of(surface_) : sphere_of(field_);
}

std::vector<Section> FieldFile::sections() const
{
    const uint8_t* bytes = bytes_.data();
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
    return lumi::detail::crc32(0, bytes() + section.offset, section.bytes) == section.crc32;
}

void FieldFile::require_intact() const
{
    for (const Section& section : sections())
        if (!is_intact(section))
            throw Failure(path_, "the " + title_of(section.type) + " section's bytes are damaged (CRC)",
                          mend_of(FieldError::section_crc));
}

}  // namespace lumi::tools
