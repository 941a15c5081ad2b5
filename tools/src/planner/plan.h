// SPDX-License-Identifier: MIT
// A plan: the layout of a field and every parameter of its bake.
#pragma once

#include <string>

#include "lumi/baker/bake.h"
#include "lumi/baker/guided.h"

namespace lumi::planner
{

enum class Layout : uint8_t { guided, focus, chord };
inline constexpr size_t kLayouts = 3;
const char* name_of(Layout layout);

// Of the two settings, one is the layout's own.
struct Plan {
    Layout layout = Layout::guided;
    baker::GuidedSettings guided;  // guided and focus
    baker::BakeSettings chord;
};

// "guided, 128 origins, chart 118, 4000 triangles, mean 96 palette8, 4-bit texels, occlusion". What equal texts
// describe bakes into the same bytes, samples, seed and jitter aside. A focus radius is in scene units.
std::string text_of(const Plan& plan);

// The options of `lumi bake` that set the same by hand.
std::string options_of(const Plan& plan);

}  // namespace lumi::planner
