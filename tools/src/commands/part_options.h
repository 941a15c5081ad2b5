// SPDX-License-Identifier: MIT
// Options that name parts which move.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "lumi/baker/scene.h"

namespace lumi::tools
{

// Whether an option may give a part's pose.
enum class PartPose : uint8_t { none, optional };

// Adds --part NAME:AXIS[@X,Y,Z], with =VALUE where a pose may be given; NAME=VALUE alone is one of the scene file. Of
// names that hold ':' or '=' the last counts.
void add_part_option(CLI::App& command, std::vector<baker::PartOptions>& parts, PartPose pose);

}  // namespace lumi::tools
