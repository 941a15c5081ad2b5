// SPDX-License-Identifier: MIT
// The Pico's loop for displays of other sizes: a firmware names its size as a type, so each has a loop here.
#pragma once

#include <string>

namespace simulator
{

// The loop for "466x466" or the like, with options set to that size; null: there is none.
int (*main_of_size(const char* name))();

// "240x240|466x466|...".
std::string size_names();

}  // namespace simulator
