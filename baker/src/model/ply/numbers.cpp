// SPDX-License-Identifier: MIT
#include "model/ply/numbers.h"

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

}  // namespace lumi::baker
