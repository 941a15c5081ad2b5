// SPDX-License-Identifier: MIT
#pragma once

namespace lumi::tools
{

inline constexpr double kPi = 3.14159265358979323846;

}  // namespace lumi::tools
