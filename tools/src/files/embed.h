// SPDX-License-Identifier: MIT
// A field as part of a program: an assembler file that includes its bytes, and a C and C++ header for them.
#pragma once

#include <string>
#include <string_view>

namespace lumi::tools
{

// Letters, digits and underscores, not beginning with a digit.
bool is_symbol(std::string_view text);
// The nearest symbol to `text`: other characters become underscores.
std::string symbol_from(std::string_view text);

// GNU assembler text for any target: section .rodata.SYMBOL, aligned to 8 bytes, global labels SYMBOL and SYMBOL_end.
// `path` is written into .incbin as it is.
std::string embed_source(const std::string& symbol, const std::string& path);

// Declares SYMBOL, SYMBOL_end and the inline function SYMBOL_size(); names core's function that opens them.
std::string embed_header(const std::string& symbol, const std::string& opener);

}  // namespace lumi::tools
