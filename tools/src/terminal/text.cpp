// SPDX-License-Identifier: MIT
#include "terminal/text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <filesystem>
#include <utility>

namespace lumi::tools
{

namespace
{

template <class Number>
std::optional<Number> parse_number(std::string_view text)
{
    Number value = {};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<double> parse_finite(std::string_view text)
{
    const std::optional<double> value = parse_number<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> parse_share(std::string_view text)
{
    constexpr double kPercent = 0.01;
    if (!text.empty() && text.back() == '%') {
        const std::optional<double> percent = parse_finite(text.substr(0, text.size() - 1));
        return percent ? std::optional<double>(*percent * kPercent) : std::nullopt;
    }
    return parse_finite(text);
}

// Three significant digits, as "%.3g" without ever an exponent. value is 0 or between 1 and 1000, rounding aside.
std::string three_digits(double value)
{
    char text[32];
    const int decimals = value < 9.995 ? 2 : value < 99.95 ? 1 : 0;
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

// `value` in the largest unit that leaves at least 1; units are a factor 1000 apart.
template <size_t kUnits>
std::string with_unit(double value, const char* const (&units)[kUnits])
{
    constexpr double kStep = 1000;
    constexpr double kRoundsUp = 999.5;
    size_t unit = 0;
    while (unit + 1 < kUnits && value >= kRoundsUp) {
        value /= kStep;
        ++unit;
    }
    return (unit == 0 ? std::to_string(std::llround(value)) : three_digits(value)) + units[unit];
}

// How many bytes of UTF-8 follow this one; none follow a byte of another code.
int following(unsigned char byte)
{
    constexpr unsigned char kTwo = 0xC2, kThree = 0xE0, kFour = 0xF0, kEnd = 0xF5;
    return byte < kTwo || byte >= kEnd ? 0 : byte < kThree ? 1 : byte < kFour ? 2 : 3;
}

// Puts '?' in the place of control characters, and returns how many bytes the text then has.
size_t make_visible(char* text, size_t size)
{
    constexpr unsigned char kDelete = 0x7F, kLastControl = 0x9F, kLatin = 0xC2;  // U+009F is C2 9F in UTF-8
    const auto is_high_control = [&](size_t i) {
        const auto byte = static_cast<unsigned char>(i < size ? text[i] : '\0');
        return byte > kDelete && byte <= kLastControl;
    };
    const auto continues = [&](size_t i) { return i < size && (text[i] & 0xC0) == 0x80; };
    size_t end = 0;
    for (size_t i = 0; i < size;) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const bool is_pair = byte == kLatin && is_high_control(i + 1);
        if ((byte < ' ' && byte != '\n') || byte == kDelete || is_high_control(i) || is_pair) {
            text[end++] = '?';
            i += is_pair ? 2 : 1;
            continue;
        }
        text[end++] = text[i++];
        for (int left = following(byte); left > 0 && continues(i); --left) text[end++] = text[i++];
    }
    return end;
}

}  // namespace

std::optional<PixelSize> parse_size(std::string_view text)
{
    const size_t cross = text.find('x');
    if (cross == std::string_view::npos) return std::nullopt;
    const auto width = parse_number<int>(text.substr(0, cross));
    const auto height = parse_number<int>(text.substr(cross + 1));
    if (!width || !height || *width < 1 || *height < 1) return std::nullopt;
    return PixelSize{*width, *height};
}

std::optional<std::array<double, 3>> parse_triple(std::string_view text)
{
    const size_t first = text.find(',');
    const size_t second = first == std::string_view::npos ? first : text.find(',', first + 1);
    if (second == std::string_view::npos) return std::nullopt;
    const auto a = parse_finite(text.substr(0, first));
    const auto b = parse_finite(text.substr(first + 1, second - first - 1));
    const auto c = parse_finite(text.substr(second + 1));
    if (!a || !b || !c) return std::nullopt;
    return std::array<double, 3>{*a, *b, *c};
}

std::optional<Rgb8> parse_colour(std::string_view text)
{
    constexpr size_t kDigits = 6;
    constexpr int kHexadecimal = 16;
    if (!text.empty() && text.front() == '#') text.remove_prefix(1);
    uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, kHexadecimal);
    if (text.size() != kDigits || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return Rgb8{static_cast<uint8_t>(value >> 16), static_cast<uint8_t>(value >> 8), static_cast<uint8_t>(value)};
}

std::optional<double> parse_cap_share(std::string_view text)
{
    if (text.find_first_of(".%") == std::string_view::npos) return std::nullopt;
    const auto share = parse_share(text);
    return share && static_cast<float>(*share) > 0 && *share <= 1 ? share : std::nullopt;
}

std::optional<uint32_t> parse_cap(std::string_view text, uint32_t origins)
{
    if (text == "1") return std::nullopt;
    const auto share = parse_cap_share(text);
    const std::optional<uint32_t> used =
        share ? static_cast<uint32_t>(std::ceil(*share * origins)) : parse_number<uint32_t>(text);
    return used && *used >= 1 && *used <= origins ? used : std::nullopt;
}

std::optional<PartOf> parse_part(std::string_view text)
{
    const size_t slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto part = parse_number<uint32_t>(text.substr(0, slash));
    const auto count = parse_number<uint32_t>(text.substr(slash + 1));
    if (!part || !count || *part < 1 || *part > *count) return std::nullopt;
    return PartOf{*part, *count};
}

std::optional<uint64_t> parse_bytes(std::string_view text)
{
    constexpr double kKilo = 1e3, kKibi = 1024, kLargest = 1e18;
    constexpr std::pair<std::string_view, double> kUnits[] = {
        {"", 1},
        {"B", 1},
        {"kB", kKilo},
        {"KB", kKilo},
        {"MB", kKilo * kKilo},
        {"GB", kKilo * kKilo * kKilo},
        {"KiB", kKibi},
        {"MiB", kKibi * kKibi},
        {"GiB", kKibi * kKibi * kKibi},
    };
    const size_t end = std::min(text.size(), text.find_first_not_of("0123456789."));
    const auto number = parse_finite(text.substr(0, end));
    for (const auto& [unit, factor] : kUnits)
        if (number && text.substr(end) == unit && *number * factor < kLargest)
            return static_cast<uint64_t>(*number * factor);
    return std::nullopt;
}

std::string byte_text(uint64_t bytes)
{
    return with_unit(static_cast<double>(bytes), {" bytes", " kB", " MB", " GB"});
}

std::string address_text(uint32_t address)
{
    char text[16];
    std::snprintf(text, sizeof text, "0x%08X", static_cast<unsigned>(address));
    return text;
}

std::string count_text(double count)
{
    return with_unit(count, {"", " k", " M", " G"});
}

std::string duration_text(double seconds)
{
    constexpr long long kMinute = 60, kHour = 3600;
    const long long total = std::llround(seconds);
    char text[48];
    if (total >= kHour)
        std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", total / kHour, total % kHour / kMinute, total % kMinute);
    else
        std::snprintf(text, sizeof text, "%lld:%02lld", total / kMinute, total % kMinute);
    return text;
}

std::string shell_word(const std::string& word)
{
    constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./+-:@%=,";
    const bool is_plain = !word.empty() && word.find_first_not_of(kPlain) == std::string::npos;
    return is_plain ? word : "'" + replaced(word, "'", "'\\''") + "'";
}

std::string visible(std::string text)
{
    text.resize(make_visible(text.data(), text.size()));
    return text;
}

void print(std::FILE* stream, const char* pattern, ...)
{
    std::array<char, 1024> few;  // messages about a full memory need none
    std::string many;
    char* text = few.data();
    va_list values, again;
    va_start(values, pattern);
    va_copy(again, values);
    const auto size = static_cast<size_t>(std::max(0, std::vsnprintf(text, few.size(), pattern, values)));
    va_end(values);
    if (size >= few.size()) {
        many.resize(size);
        text = many.data();
        std::vsnprintf(text, size + 1, pattern, again);
    }
    va_end(again);
    std::fwrite(text, 1, make_visible(text, size), stream);
}

std::string small_ending(const std::string& path)
{
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return ending;
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

}  // namespace lumi::tools
