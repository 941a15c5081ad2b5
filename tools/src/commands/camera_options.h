// SPDX-License-Identifier: MIT
// The camera options of `lumi render` and `lumi reference`, defined once.
#pragma once

#include <CLI/CLI.hpp>

#include "draw/views.h"

namespace lumi::tools
{

// Adds --size, --orbit, --fov, --stereo, --turntable and --background; parsed values go to `options`, which must
// outlive the parse.
void add_camera_options(CLI::App& command, ViewOptions& options);

}  // namespace lumi::tools
