// SPDX-License-Identifier: MIT
// Modelled rates of named chips, for the field that the simulator draws.
#pragma once

#include <string>

namespace simulator
{

// Frames a second; 0 for a chip that nobody knows.
double rate_of(const char* chip);

// "rp2040|rp2350|...".
std::string chip_names();

}  // namespace simulator
