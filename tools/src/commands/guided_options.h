// SPDX-License-Identifier: MIT
// The options of `lumi bake` for guided layouts.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "lumi/baker/guided.h"

namespace lumi::tools
{

enum class Layout { chord, guided, focus, surface };

struct GuidedOptions {
    Layout layout = Layout::chord;
    baker::GuidedSettings settings;
    std::vector<float> focus;
    bool no_occlusion = false;
};

// Adds --layout and what only guided layouts have; `options` must outlive the parse.
void add_guided_options(CLI::App& command, GuidedOptions& options);

// Throws UsageError where an option was given that the layout has no use for.
void require_fitting_options(const CLI::App& command, const GuidedOptions& options);

// The settings that only guided layouts have.
baker::GuidedSettings guided_settings(const GuidedOptions& options);

// What the proxy of a field is and gets wrong, a line; nothing where there is none.
std::string proxy_text(const baker::GuidedBake& bake);

}  // namespace lumi::tools
