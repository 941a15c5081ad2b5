// SPDX-License-Identifier: MIT
#include "program/option_checks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

template <class Number>
std::optional<Number> parsed(const std::string& word)
{
    Number value = {};
    const char* const end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), end, value);
    return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

std::string text_of(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

bool is_control(char c)
{
    constexpr unsigned char kDelete = 127;
    const auto byte = static_cast<unsigned char>(c);
    return byte < ' ' || byte == kDelete;
}

std::string not_this(const std::string& word)
{
    return ", not \"" + replaced(visible(word), "\n", "?") + "\"";
}

std::string plain_word(const std::string& word)
{
    if (word.empty()) return "takes a word, not an empty one";
    if (word == "-")
        return "takes a word, not \"-\": name a file; none is read from standard input or written to standard output";
    if (std::none_of(word.begin(), word.end(), is_control)) return "";
    return "takes a word without line breaks and other control characters" + not_this(word);
}

}  // namespace

WordCheck whole_number(uint64_t least, uint64_t most)
{
    return [least, most](const std::string& word) -> std::string {
        const auto value = parsed<uint64_t>(word);
        if (value && *value >= least && *value <= most) return "";
        return "takes a whole number from " + std::to_string(least) + " to " + std::to_string(most) + not_this(word);
    };
}

WordCheck number(double least, double most)
{
    return [least, most](const std::string& word) -> std::string {
        const auto value = parsed<double>(word);
        if (value && *value >= least && *value <= most) return "";
        return "takes a number from " + text_of(least) + " to " + text_of(most) + not_this(word);
    };
}

WordCheck any_number()
{
    return [](const std::string& word) -> std::string {
        const auto value = parsed<float>(word);
        return value && std::isfinite(*value) ? "" : "takes a number" + not_this(word);
    };
}

WordCheck one_of(const std::vector<int>& numbers)
{
    std::string listed;
    for (size_t k = 0; k < numbers.size(); ++k)
        listed += (k == 0 ? "" : k + 1 == numbers.size() ? " or " : ", ") + std::to_string(numbers[k]);
    return [numbers, listed](const std::string& word) -> std::string {
        const auto value = parsed<int>(word);
        const bool is_known = value && std::find(numbers.begin(), numbers.end(), *value) != numbers.end();
        return is_known ? "" : "takes " + listed + not_this(word);
    };
}

std::string wrong_page_name(const std::string& word)
{
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(word, ignored);
    const std::string ending = small_ending(word);
    if (ending == ".html" || ending == ".htm" || std::filesystem::is_character_file(status) ||
        std::filesystem::is_fifo(status))
        return "";
    return "takes a page (.html)" + not_this(word);
}

void require_plain_words(CLI::App& app)
{
    for (CLI::Option* option : app.get_options())
        if (option->get_expected_min() > 0) option->check(plain_word);
    for (CLI::App* command : app.get_subcommands(nullptr)) require_plain_words(*command);
}

namespace
{

// Two texts, each before, between and after the same two words.
struct Wording {
    const char *before, *between, *after, *our_before, *our_between, *our_after;
};
constexpr Wording kOfChecks = {"", ": takes ", "", "", " takes ", ""};
constexpr Wording kWordings[] = {
    {"", ": At Most 1 required but received ", "", "", " is given ", " times; give it once"},
    {"", ": At most 1 required but received ", "", "", " is given ", " times; give it once"},
    {"", ": 1 required ", " missing", "", " needs a value behind it: ", ""},
    {"Could not convert: ", " = ", "", "", " takes no value, not \"", "\""},
    {"", " excludes ", "", "", " does not go with ", "; leave one of them out"},
    {"", " requires ", "", "", " needs ", " beside it"},
    {"", " is required", "", "", " is missing", ""},
};

// In our words, or nothing where it is none of theirs.
std::optional<std::string> in_our_words(const std::string& text, const Wording& w)
{
    const std::string before = w.before, between = w.between, after = w.after;
    const size_t first = before.size(), at = text.find(between, first), second = at + between.size();
    if (text.compare(0, first, before) != 0 || at == std::string::npos || text.size() < second + after.size() ||
        text.compare(text.size() - after.size(), after.size(), after) != 0)
        return std::nullopt;
    return w.our_before + text.substr(first, at - first) + w.our_between +
           text.substr(second, text.size() - after.size() - second) + w.our_after;
}

}  // namespace

std::string parse_problem(const CLI::ParseError& error)
{
    const std::string text = replaced(visible(error.what()), "\n", "?");
    if (error.get_name() == "ValidationError") return in_our_words(text, kOfChecks).value_or(text);
    for (const Wording& wording : kWordings)
        if (const auto ours = in_our_words(text, wording)) return *ours;
    return text;
}

CLI::Option* add_list(CLI::App& command, const std::string& name, const std::function<void(const std::string&)>& set,
                      const std::string& description)
{
    const auto set_all = [name, set](const std::string& words) {
        for (size_t begin = 0; begin <= words.size();) {
            const size_t end = std::min(words.find_first_of(",\n", begin), words.size());
            if (end == begin) throw CLI::ValidationError(name, "takes no empty word between commas" + not_this(words));
            set(words.substr(begin, end - begin));
            begin = end + 1;
        }
    };
    return command.add_option_function<std::string>(name, set_all, description)->join();  // by line breaks
}

}  // namespace lumi::tools
