// SPDX-License-Identifier: MIT
// Ranges of numbers that several readers of scene files share.
#pragma once

#include "util/json_members.h"

namespace lumi::baker
{

inline constexpr NumberRange kPlace = {-1e15, 1e15};  // scene units
inline constexpr NumberRange kLength = {1e-9, 1e15};  // scene units
inline constexpr NumberRange kAngle = {-360, 360};    // degrees
inline constexpr NumberRange kShare = {0, 1};
inline constexpr NumberRange kScalar = {-1e30, 1e30};  // values of a volume's grid

}  // namespace lumi::baker
