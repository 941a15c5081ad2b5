// SPDX-License-Identifier: MIT
#include "program/option_checks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
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

void require_plain_words(CLI::App& app)
{
    for (CLI::Option* option : app.get_options())
        if (option->get_expected_min() > 0) option->check(plain_word);
    for (CLI::App* command : app.get_subcommands(nullptr)) require_plain_words(*command);
}

std::string parse_problem(const CLI::ParseError& error)
{
    const std::string text = replaced(visible(error.what()), "\n", "?"), colon = ": takes ";
    const size_t at = text.find(colon);
    return at == std::string::npos ? text : text.substr(0, at) + text.substr(at + 1);
}

}  // namespace lumi::tools
