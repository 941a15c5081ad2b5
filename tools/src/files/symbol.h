// SPDX-License-Identifier: MIT
// Names that a program cannot give to its data.
#pragma once

#include <string_view>

namespace lumi::tools
{

// Whether C or C++ means something else by this word: keywords of any edition, what <stdint.h> defines for an embedded
// field's header, and the words that compilers define themselves.
bool is_taken(std::string_view symbol);

}  // namespace lumi::tools
