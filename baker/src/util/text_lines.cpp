// SPDX-License-Identifier: MIT
#include "util/text_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "lumi/baker/file_guard.h"
#include "lumi/baker/scene.h"

namespace lumi::baker
{
namespace
{

constexpr uintmax_t kMaxFileBytes = uintmax_t{1} << 32;

// Lambdas, since a pointer to a function would not be inlined in find_first().
constexpr auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; };
constexpr auto is_no_blank = [](char c) { return !is_blank(c); };
constexpr auto ends_line = [](char c) { return c == '\r' || c == '\n'; };

// The place of the first character that `is` holds for, or the end. string_view::find_first_of takes three times as
// long.
template <class Is>
size_t find_first(std::string_view s, Is is)
{
    return static_cast<size_t>(std::find_if(s.begin(), s.end(), is) - s.begin());
}

void skip_blanks(std::string_view& s)
{
    s.remove_prefix(find_first(s, is_no_blank));
}

std::string_view trimmed(std::string_view s)
{
    skip_blanks(s);
    while (!s.empty() && is_blank(s.back())) s.remove_suffix(1);
    return s;
}

// Takes one physical line off the front of `rest`.
std::string_view take_line(std::string_view& rest)
{
    const size_t end = find_first(rest, ends_line);
    const std::string_view line = rest.substr(0, end);
    size_t next = std::min(end + 1, rest.size());
    if (end + 1 < rest.size() && rest[end] == '\r' && rest[end + 1] == '\n') ++next;
    rest.remove_prefix(next);
    return line;
}

// A '#' opens a comment only where a word could start: file names may contain it.
std::string_view without_comment(std::string_view line)
{
    for (size_t k = 0; k < line.size(); ++k)
        if (line[k] == '#' && (k == 0 || is_blank(line[k - 1]))) return line.substr(0, k);
    return line;
}

// A backslash at the end of a comment is a part of it.
bool goes_on(std::string_view line)
{
    return !line.empty() && line.back() == '\\' && without_comment(line).size() == line.size();
}

// The line has no blanks in front.
bool begins_with_a_name(std::string_view line)
{
    constexpr size_t kWord = 6;
    const std::string_view word = line.substr(0, kWord);
    return (word == "newmtl" || word == "usemtl") && line.size() > kWord && is_blank(line[kWord]);
}

// Takes one logical line off the front of `rest`, without blanks in front, and counts its physical lines. Looks at each
// piece once, however many there are.
void take_joined_line(std::string_view& rest, std::string& joined, uint32_t& number)
{
    joined.clear();
    for (;;) {
        std::string_view line = take_line(rest);
        ++number;
        const bool joins = goes_on(line);
        if (joined.empty()) skip_blanks(line);
        joined += line;
        if (!joins || begins_with_a_name(joined)) return;
        joined.back() = ' ';
        if (joined.size() == 1) joined.clear();
    }
}

// "+-1" is no number.
std::string_view without_plus(std::string_view word)
{
    return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

template <class T>
bool parse_whole(std::string_view word, T& value)
{
    word = without_plus(word);
    const std::from_chars_result r = std::from_chars(word.data(), word.data() + word.size(), value);
    return r.ec == std::errc() && r.ptr == word.data() + word.size();
}

// Bytes; 0 if it is not there.
uintmax_t size_of(const std::filesystem::path& file)
{
    std::error_code failed;
    const uintmax_t size = std::filesystem::file_size(file, failed);
    return failed ? 0 : size;
}

bool is_utf16(std::string_view text)
{
    return text.substr(0, 2) == "\xFF\xFE" || text.substr(0, 2) == "\xFE\xFF";
}

}  // namespace

std::string at(const Place& place, const std::string& text)
{
    std::string shown = text;
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, '?');
    return place.file + (place.line ? ":" + std::to_string(place.line) : "") + ": " + shown;
}

std::ifstream open_file(const std::filesystem::path& file)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        throw SceneError(at({file.string()}, "this is a folder; name the file in it"));
    if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored))
        throw SceneError(at({file.string()}, "this is a device or a pipe; name a file"));
    const uintmax_t size = size_of(file);
    if (size > kMaxFileBytes) {
        throw SceneError(at({file.string()}, "the file has " + std::to_string(size) + " bytes, at most " +
                                                 std::to_string(kMaxFileBytes) + " are read; split or simplify it"));
    }
    note_input(file);
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw SceneError(at({file.string()}, "the file cannot be opened; check its name and permissions"));
    return stream;
}

std::string read_file(const std::filesystem::path& file)
{
    std::ifstream stream = open_file(file);
    const uintmax_t size = std::min<uintmax_t>(size_of(file), kMaxFileBytes);
    std::string text(static_cast<size_t>(size), '\0');
    stream.read(text.data(), static_cast<std::streamsize>(size));
    if (stream.bad()) throw SceneError(at({file.string()}, "reading the file failed; check the disk"));
    text.resize(static_cast<size_t>(stream.gcount()));  // somebody may have cut it meanwhile
    return text;
}

std::string read_text(const std::filesystem::path& file)
{
    std::string text = read_file(file);
    if (is_utf16(text)) throw SceneError(at({file.string()}, "this text is in UTF-16; save it in UTF-8"));
    return text;
}

Lines::Lines(std::string_view text) : rest_(text)
{
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) rest_.remove_prefix(kByteOrderMark.size());
}

bool Lines::next(Line& line)
{
    while (!rest_.empty()) {
        line.number = number_ + 1;
        take_joined_line(rest_, joined_, number_);
        const std::string_view content = trimmed(without_comment(joined_));
        if (content.empty()) continue;
        const size_t end = find_first(content, is_blank);
        line.keyword.assign(content.substr(0, end));
        line.argument.assign(trimmed(content.substr(end)));
        return true;
    }
    return false;
}

std::string_view take_word(std::string_view& text)
{
    skip_blanks(text);
    const std::string_view word = text.substr(0, find_first(text, is_blank));
    text.remove_prefix(word.size());
    skip_blanks(text);
    return word;
}

std::vector<std::string_view> words(std::string_view argument)
{
    std::vector<std::string_view> result;
    for (;;) {
        const std::string_view word = take_word(argument);
        if (word.empty()) return result;
        result.push_back(word);
    }
}

std::string in_small_letters(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

std::string joined(const std::vector<std::string>& parts, const char* separator)
{
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : separator) + part;
    return text;
}

std::string number_text(double value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

bool parse_finite(std::string_view word, double& value)
{
    return parse_whole(word, value) && std::isfinite(value);
}

bool parse_integer(std::string_view word, int64_t& value)
{
    return parse_whole(word, value);
}

std::vector<double> numbers_of(const Place& place, const Line& line, size_t least, size_t most, double limit)
{
    const std::vector<std::string_view> list = words(line.argument);
    if (list.size() < least) {
        throw SceneError(at(place, "'" + line.keyword + "' needs " + std::to_string(least) + " numbers and has " +
                                       std::to_string(list.size()) + "; export the file again"));
    }
    std::vector<double> numbers(std::min(list.size(), most));
    for (size_t k = 0; k < numbers.size(); ++k) {
        if (!parse_finite(list[k], numbers[k])) {
            throw SceneError(
                at(place, "'" + std::string(list[k]) + "' is not a finite number; correct it or remove what uses it"));
        }
        if (std::abs(numbers[k]) > limit)
            throw SceneError(at(place, "the number " + std::string(list[k]) + " is too large; scale the scene down"));
    }
    return numbers;
}

}  // namespace lumi::baker
