// SPDX-License-Identifier: MIT
#include "program/help_formatter.h"

#include <sstream>

namespace lumi::tools
{

namespace
{

constexpr size_t kOptionColumns = 36, kDescriptionColumns = 64;

}  // namespace

std::string wrapped(const std::string& text, size_t columns)
{
    std::istringstream words(text);
    std::string result, word;
    size_t length = 0;
    while (words >> word) {
        const bool fits = length == 0 || length + 1 + word.size() <= columns;
        if (length > 0) result += fits ? ' ' : '\n';
        length = fits && length > 0 ? length + 1 + word.size() : word.size();
        result += word;
    }
    return result;
}

HelpFormatter::HelpFormatter()
{
    column_width(kOptionColumns);
    label("REQUIRED", "(required)");
    label("TEXT", "");
}

// At least two spaces stand before a description.
std::string HelpFormatter::make_option_opts(const CLI::Option* option) const
{
    return CLI::Formatter::make_option_opts(option) + " ";
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const
{
    return wrapped(CLI::Formatter::make_option_desc(option), kDescriptionColumns);
}

}  // namespace lumi::tools
