// SPDX-License-Identifier: MIT
#include "filter/weights_file.h"

#include <cmath>
#include <cstring>
#include <fstream>

#include "field/sections.h"
#include "lumi/baker/file_guard.h"
#include "lumi/detail/crc32.h"
#include "store/section_writer.h"
#include "terminal/failure.h"
#include "util/byte_stream.h"
#include "util/digest.h"

namespace lumi::filter
{

namespace
{

constexpr size_t kMostBytes =
    4096 + sizeof(float) * number_count(kSurfacePlanes);  // the head and the settings are short
constexpr char kMend[] = "copy the file again, or train it again by `lumi filter train`";

std::vector<uint8_t> settings_bytes(const Weights& weights)
{
    baker::ByteWriter out;
    out.put32(kNetworkVersion);
    out.put32(weights.input_planes);
    out.put32(weights.gains ? 1 : 0);
    out.put32(0);
    for (const uint64_t v : weights.subject.scene) out.put64(v);
    for (const uint64_t v : weights.subject.field) out.put64(v);
    for (const uint32_t v : weights.subject.sphere) out.put32(v);
    return out.bytes();
}

std::vector<uint8_t> number_bytes(const Weights& weights)
{
    baker::ByteWriter out;
    if (weights.gains)
        for (const float v : weights.numbers) out.put_float(v);
    return out.bytes();
}

void append(std::string& file, std::vector<uint8_t> section)
{
    section.resize(baker::aligned(section.size()));
    file.append(section.begin(), section.end());
}

// The two sections of a file that was checked.
struct Sections {
    detail::container::Section settings, numbers;
};

class Decoder
{
public:
    Decoder(std::string_view bytes, const std::string& name)
        : bytes_(reinterpret_cast<const uint8_t*>(bytes.data())), size_(bytes.size()), name_(name)
    {
    }

    Weights weights() const
    {
        const Sections sections = checked_sections();
        Weights result = settings(sections.settings);
        const size_t count = result.gains ? number_count(result.input_planes) : 0;
        if (sections.numbers.size != count * sizeof(float)) fail("its numbers are not as many as its network takes");
        baker::ByteReader in(bytes_ + sections.numbers.offset, sections.numbers.size);
        for (size_t k = 0; k < count; ++k) result.numbers.push_back(in.get_float());
        for (const float v : result.numbers)
            if (!std::isfinite(v)) fail("one of its numbers is not finite");
        return result;
    }

private:
    [[noreturn]] void fail(const std::string& problem) const { throw tools::Failure(name_, problem, kMend); }

    void require(FieldError error) const
    {
        if (error == FieldError::bad_magic) fail("holds no weights of a filter");
        if (error != FieldError::none) fail(describe(error));
    }

    Sections checked_sections() const
    {
        static constexpr uint32_t kTypes[] = {kSettingsSection, kNumbersSection};
        require(detail::container::check_table(bytes_, size_));
        Sections found;
        if (!detail::container::find_section(bytes_, kSettingsSection, found.settings) ||
            !detail::container::find_section(bytes_, kNumbersSection, found.numbers))
            fail("holds no weights of a filter");
        require(detail::container::check_sections(bytes_, {kTypes, 2}));
        for (const detail::container::Section& section : {found.settings, found.numbers})
            if (detail::crc32(0, bytes_ + section.offset, section.size) != section.crc)
                require(FieldError::section_crc);
        return found;
    }

    Weights settings(const detail::container::Section& section) const
    {
        if (section.size != kSettingsBytes) fail("its settings have the wrong size");
        baker::ByteReader in(bytes_ + section.offset, section.size);
        if (in.get32() != kNetworkVersion) fail("was written by another version of lumi");
        Weights result;
        result.input_planes = in.get32();
        const uint32_t gains = in.get32(), reserved = in.get32();
        result.gains = gains == 1;
        const bool known = result.input_planes == kPicturePlanes || result.input_planes == kSurfacePlanes;
        if (!known || gains > 1 || reserved != 0) fail("its settings are none that this lumi writes");
        for (uint64_t& v : result.subject.scene) v = in.get64();
        for (uint64_t& v : result.subject.field) v = in.get64();
        for (uint32_t& v : result.subject.sphere) v = in.get32();
        return result;
    }

    const uint8_t* bytes_;
    size_t size_;
    const std::string& name_;
};

}  // namespace

bool Subject::operator==(const Subject& other) const
{
    return scene == other.scene && field == other.field && sphere == other.sphere;
}

Subject subject_of(const tools::FieldFile& field)
{
    baker::Digest digest;
    digest.add_bytes(field.bytes(), field.size());
    Subject subject;
    subject.field = digest.value();
    if (field.is_surface()) {
        for (size_t k = 0; k < subject.sphere.size(); ++k)
            subject.sphere[k] = detail::container::load_u32(field.surface().sphere + 4 * k);
    } else {
        const auto& centre = field.field().centre_bits;
        subject.sphere = {centre[0], centre[1], centre[2], field.field().radius_bits};
    }
    return subject;
}

std::string encode(const Weights& weights)
{
    const std::vector<uint8_t> settings = settings_bytes(weights), numbers = number_bytes(weights);
    const std::vector<uint8_t> head = baker::file_head({{kSettingsSection, settings.size(), baker::crc_of(settings)},
                                                        {kNumbersSection, numbers.size(), baker::crc_of(numbers)}});
    std::string file(head.begin(), head.end());
    append(file, settings);
    append(file, numbers);
    return file;
}

Weights decode(std::string_view bytes, const std::string& name)
{
    return Decoder(bytes, name).weights();
}

Weights read_weights(const std::string& path)
{
    baker::note_input(path);
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw tools::Failure(path, std::string("cannot be read (") + std::strerror(errno) + ")", "check the path");
    std::string bytes(kMostBytes, '\0');  // a device may have no end
    bytes.resize(static_cast<size_t>(file.read(bytes.data(), kMostBytes).gcount()));
    if (bytes.size() == kMostBytes) throw tools::Failure(path, "is larger than any weights of a filter", kMend);
    return decode(bytes, path);
}

void require_fitting(const Weights& weights, const std::string& path, const tools::FieldFile& field, bool forced)
{
    if (weights.input_planes == kSurfacePlanes && !field.is_surface())
        throw tools::Failure(path, "was trained on a surface field, and " + field.path() + " is a chord field",
                             "train a filter for this field");
    const Subject own = subject_of(field);
    if (forced || own.field == weights.subject.field) return;
    const bool same_sphere = own.sphere == weights.subject.sphere;
    throw tools::Failure(path,
                         "was trained on another field than " + field.path() +
                             (same_sphere ? "" : ", of another scene: it would make the picture worse"),
                         "train a filter for this field, or add --force-filter");
}

}  // namespace lumi::filter
