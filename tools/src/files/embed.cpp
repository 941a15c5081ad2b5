// SPDX-License-Identifier: MIT
#include "files/embed.h"

#include <algorithm>

namespace lumi::tools
{

namespace
{

bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

// Inside an assembler string.
std::string quoted(const std::string& path)
{
    return replaced(replaced(path, "\\", "\\\\"), "\"", "\\\"");
}

}  // namespace

bool is_symbol(std::string_view text)
{
    return !text.empty() && !is_digit(text.front()) &&
           std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

std::string symbol_from(std::string_view text)
{
    std::string symbol(text);
    for (char& c : symbol)
        if (!is_letter(c) && !is_digit(c)) c = '_';
    return symbol.empty() || is_digit(symbol.front()) ? "_" + symbol : symbol;
}

// %progbits, not @progbits: in ARM assembler @ begins a comment. The path goes in last: it may hold any text.
std::string embed_source(const std::string& symbol, const std::string& path)
{
    const std::string text = R"(/* Written by `lumi embed`. Change the field, not this file. */
    .section .rodata.@SYMBOL@, "a", %progbits
    .balign 8
    .global @SYMBOL@
    .global @SYMBOL@_end
    .type @SYMBOL@, %object
@SYMBOL@:
    .incbin "@PATH@"
@SYMBOL@_end:
    .size @SYMBOL@, @SYMBOL@_end - @SYMBOL@
    .section .note.GNU-stack, "", %progbits
)";
    return replaced(replaced(text, "@SYMBOL@", symbol), "@PATH@", quoted(path));
}

std::string embed_header(const std::string& symbol, const std::string& opener)
{
    const std::string text = R"(/* Written by `lumi embed`. Change the field, not this file. */
#ifndef LUMI_EMBEDDED_@SYMBOL@
#define LUMI_EMBEDDED_@SYMBOL@

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The bytes of a field file, aligned to 8: lumi::@OPENER@(@SYMBOL@, @SYMBOL@_size(), field). */
extern const uint8_t @SYMBOL@[];
extern const uint8_t @SYMBOL@_end[];

static inline size_t @SYMBOL@_size(void)
{
    return (size_t)(@SYMBOL@_end - @SYMBOL@);
}

#ifdef __cplusplus
}
#endif

#endif
)";
    return replaced(replaced(text, "@OPENER@", opener), "@SYMBOL@", symbol);
}

}  // namespace lumi::tools
