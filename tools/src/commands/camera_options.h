// SPDX-License-Identifier: MIT
// Defines once the options that several commands share: cameras, and the devices that draw a field.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "../planner/speed.h"
#include "draw/views.h"
#include "lumi/host/view_memory.h"

namespace lumi::tools
{

// Adds --size, --orbit, --pose, --fov, --turntable, --background and --over; parsed values go to `options`,
// which must outlive the parse. `background` is the word that --background has where nobody gives it.
void add_camera_options(CLI::App& command, ViewOptions& options, const std::string& background);

// Adds --orbit and --background alone, of a page.
void add_start_options(CLI::App& command, ViewOptions& options);

// Adds -o, which takes names that `wrong_name` has nothing to say about.
void add_picture_output(CLI::App& command, std::string& output, const std::string& type,
                        std::string (*wrong_name)(const std::string&));

// Adds "--for LIST", a list of PART or PART@RATEfps: which parts draw, and how many frames a second they should reach.
// `paces` must outlive the parse. Another word is refused.
void add_pace_option(CLI::App& command, std::vector<planner::Pace>& paces, const std::string& description,
                     bool takes_two = false);

// Adds --screen and --rows, what a device shows a field on; `screen` must outlive the parse.
void add_screen_options(CLI::App& command, host::ScreenSize& screen);

}  // namespace lumi::tools
