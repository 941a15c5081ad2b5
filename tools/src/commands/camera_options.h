// SPDX-License-Identifier: MIT
// The camera options of `lumi render`, `lumi reference` and `lumi view`, defined once.
#pragma once

#include <CLI/CLI.hpp>

#include "draw/views.h"

namespace lumi::tools
{

// Adds --size, --orbit, --pose, --fov, --stereo, --turntable, --background and --over; parsed values go to `options`,
// which must outlive the parse.
void add_camera_options(CLI::App& command, ViewOptions& options);

// Adds --orbit and --background alone.
void add_start_options(CLI::App& command, ViewOptions& options);

// Adds -o, which takes names that `wrong_name` has nothing to say about.
void add_picture_output(CLI::App& command, std::string& output, const std::string& type,
                        std::string (*wrong_name)(const std::string&));

}  // namespace lumi::tools
