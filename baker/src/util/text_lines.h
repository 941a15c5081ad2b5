// SPDX-License-Identifier: MIT
// Walks the lines of a text file and says, of each fault, where it is and how to mend it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace lumi::baker
{

// Names a place in a text file, for messages; line 0 is the file as a whole.
struct Place {
    std::string file;
    uint32_t line = 0;
};

// Returns "file:line: text". What terminals obey, or what ends a text, is shown as a question mark: text may quote a
// file.
std::string at(const Place& place, const std::string& text);

// Opens a file to read its bytes, and notes it as an input (file_guard.h). Throws SceneError if it is no file, larger
// than 4 GiB or cannot be opened.
std::ifstream open_file(const std::filesystem::path& file);
// Opens a file so and reads it. Throws SceneError if it cannot be read.
std::string read_file(const std::filesystem::path& file);
// Reads a file of text so. Refuses UTF-16.
std::string read_text(const std::filesystem::path& file);

// One logical line: continuation lines (ending in a backslash) joined, comment and surrounding blanks cut off. A
// backslash at the end of a comment, or of the name behind newmtl or usemtl, joins nothing.
struct Line {
    uint32_t number;       // the number of its first physical line, from 1
    std::string keyword;   // first word
    std::string argument;  // the rest
};

// Walks the lines of a text that say something. Accepts LF, CR LF and CR.
class Lines
{
public:
    // `text` must outlive this.
    explicit Lines(std::string_view text);
    // Overwrites `line`; false at the end.
    bool next(Line& line);

private:
    std::string_view rest_;
    uint32_t number_ = 0;
    std::string joined_;
};

// Takes the first word off the front, and blanks with it. Empty where there is none.
std::string_view take_word(std::string_view& text);
// Returns the words of a line's argument.
std::vector<std::string_view> words(std::string_view argument);

// Changes ASCII letters only.
std::string in_small_letters(std::string text);

// Returns all parts with the separator between them.
std::string joined(const std::vector<std::string>& parts, const char* separator);

// Writes a number for messages with six digits at most, "0.25".
std::string number_text(double value);

// Reads a finite number; false for anything else, such as nan, inf, 1e999 or "1,5".
bool parse_finite(std::string_view word, double& value);
bool parse_integer(std::string_view word, int64_t& value);

// The first `least` to `most` words of the line, which must be finite numbers of at most `limit` in magnitude. Throws
// SceneError.
std::vector<double> numbers_of(const Place& place, const Line& line, size_t least, size_t most, double limit);

}  // namespace lumi::baker
