// SPDX-License-Identifier: MIT
// Which kind of field `lumi bake` writes: by --layout, or by the options that only one kind has.
#pragma once

#include <CLI/CLI.hpp>

namespace lumi::tools
{

enum class Layout { automatic, surface, chord };

// Adds --layout; `layout` must outlive the parse.
void add_layout_option(CLI::App& command, Layout& layout);

// `layout`, or where that is automatic the one that has use for the options that were given; automatic if there are
// none. Throws UsageError for an option that the layout has no use for, and for options of both.
Layout resolved_layout(const CLI::App& command, Layout layout);

}  // namespace lumi::tools
