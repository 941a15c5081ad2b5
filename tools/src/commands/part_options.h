// SPDX-License-Identifier: MIT
// Options that name parts which move.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "draw/draw_surface.h"
#include "files/field_file.h"
#include "lumi/baker/scene.h"

namespace lumi::tools
{

// An option says how a part moves, or how it moves and its pose.
enum class PartWords : uint8_t { motion, motion_and_pose };

// Adds --part NAME:AXIS[@X,Y,Z], with =VALUE where a pose may be given; NAME=VALUE is one of a part that is known. Of
// names that hold ':' or '=' the last counts; where no axis lies behind that ':', it is part of the name.
void add_part_option(CLI::App& command, std::vector<baker::PartOptions>& parts, PartWords words);

// Adds --part NAME=VALUE, or NAME=FROM..TO for the views of a turntable.
void add_pose_option(CLI::App& command, std::vector<PartPose>& poses);

// The poses of a field's own parts in a view; `done` is Eye::done. Throws Failure where it has no part of a name.
std::vector<PartValue> values_of(const std::vector<PartPose>& poses, const FieldFile& field, double done = 0);

}  // namespace lumi::tools
