// SPDX-License-Identifier: MIT
// Help texts that fit a terminal. tools/packaging/pages.py reads them.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace lumi::tools
{

// `text` with line breaks in place of spaces where a line would be longer than `columns`; longer words stay whole.
std::string wrapped(const std::string& text, size_t columns);

class HelpFormatter : public CLI::Formatter
{
public:
    HelpFormatter();
    std::string make_option_opts(const CLI::Option* option) const override;
    std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace lumi::tools
