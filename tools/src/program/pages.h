// SPDX-License-Identifier: MIT
// Man pages and bash completion, made of the options that the commands register: they cannot say anything else.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace lumi::tools
{

// A page in troff's man macros, of the program or of one of its subcommands.
std::string man_page(const CLI::App& app);

// A script for bash: words are subcommands, options, and the values of options that take one of a list.
std::string bash_completion(const CLI::App& lumi);

// --pages FOLDER of the program: writes both as a `share` folder has them, man/man1 and bash-completion/completions,
// and ends the parse.
void add_pages(CLI::App& lumi);

}  // namespace lumi::tools
