// SPDX-License-Identifier: MIT
// "Did you mean": the word of a list that a mistyped one is nearest to.
#pragma once

#include <string>
#include <vector>

namespace lumi::tools
{

// By edits of a letter (put in, left out, exchanged, or two that changed places); at most a third of the letters and at
// least one. Empty if none is that near. The first of several.
std::string nearest_word(const std::string& typed, const std::vector<std::string>& words);

}  // namespace lumi::tools
