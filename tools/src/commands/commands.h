// SPDX-License-Identifier: MIT
// The subcommands of `lumi`. Each add_… registers its options and runs while CLI11 parses; failures leave as
// exceptions.
#pragma once

#include <CLI/CLI.hpp>

namespace lumi::tools
{

void add_bake(CLI::App& lumi);
void add_merge(CLI::App& lumi);
void add_render(CLI::App& lumi);
void add_view(CLI::App& lumi);
void add_reference(CLI::App& lumi);
void add_compare(CLI::App& lumi);
void add_report(CLI::App& lumi);
void add_inspect(CLI::App& lumi);
void add_embed(CLI::App& lumi);

}  // namespace lumi::tools
