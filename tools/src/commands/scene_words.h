// SPDX-License-Identifier: MIT
// A command that reads a scene tells by which words `lumi bake` reads the same one.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "commands/scene_options.h"

namespace lumi::tools
{

// Whether a pose, a weight or a base colour is chosen, as only references and pictures have them.
bool has_choices(const SceneOptions& options);

// The scene as a bake reads it: parts at rest, all lights on, base colours to be chosen later.
SceneOptions without_choices(SceneOptions options);

// The options of `lumi bake` for that scene, as a shell takes them, with a space behind each. `command` has parsed the
// options.
std::string scene_words(const CLI::App& command, const SceneOptions& options);

}  // namespace lumi::tools
