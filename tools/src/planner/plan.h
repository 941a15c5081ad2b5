// SPDX-License-Identifier: MIT
// A plan: every parameter of a chord field's bake.
#pragma once

#include <string>

#include "lumi/baker/bake.h"

namespace lumi::planner
{

struct Plan {
    baker::BakeSettings chord;
};

// "chord, 700 origins (uppermost 630), 700 directions, palette8". What equal texts describe bakes into the same bytes,
// samples and seed aside.
std::string text_of(const Plan& plan);

// The options of `lumi bake` that set the same by hand.
std::string options_of(const Plan& plan);

}  // namespace lumi::planner
