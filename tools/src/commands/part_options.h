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

// What an option says of a part: how it moves, also its pose, or that alone.
enum class PartWords : uint8_t { motion, motion_and_pose, pose };

// Adds --part NAME:AXIS[@X,Y,Z], with =VALUE where a pose may be given; NAME=VALUE is one of a part that is known. Of
// names that hold ':' or '=' the last counts.
void add_part_option(CLI::App& command, std::vector<baker::PartOptions>& parts, PartWords words);

// The poses of a field's own parts. Throws Failure where it has no part of a name.
std::vector<PartValue> values_of(const std::vector<baker::PartOptions>& parts, const FieldFile& field);

}  // namespace lumi::tools
