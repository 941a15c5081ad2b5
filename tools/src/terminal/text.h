// SPDX-License-Identifier: MIT
// People type words after options and read others: these go both ways between text and values.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "lumi/color.h"

namespace lumi::tools
{

// Parsers take the whole text or give nothing: no spaces, no trailing characters.

// Reads "240x320": both sides at least 1.
struct PixelSize {
    int width_px, height_px;
};
std::optional<PixelSize> parse_size(std::string_view text);

// Reads "30,20,3": three finite numbers.
std::optional<std::array<double, 3>> parse_triple(std::string_view text);

// Reads "ff8000" or "#ff8000".
std::optional<Rgb8> parse_colour(std::string_view text);

// How many of `origins` rows a cap keeps: "512" is a number of origins; "50%" and "0.5" are shares of them, rounded up.
// Nothing unless the result is 1 .. origins. "1" is nothing: it could mean one origin, or all as "1.0" does.
std::optional<uint32_t> parse_cap(std::string_view text, uint32_t origins);

// The share that a cap's text is: "50%", "0.5", "1.0". Nothing for whole numbers, and unless 0 < share <= 1.
std::optional<double> parse_cap_share(std::string_view text);

// "3/16": two whole numbers, 1 <= part <= count.
struct PartOf {
    uint32_t part, count;
};
std::optional<PartOf> parse_part(std::string_view text);

// "2MB", "512KiB", "1.5MB", "300000": B, kB, MB, GB are powers of 1000; KiB, MiB, GiB of 1024. KB is kB.
std::optional<uint64_t> parse_bytes(std::string_view text);

// Writes "4.20 MB": units of 1000, three digits.
std::string byte_text(uint64_t bytes);
// Writes "0x10100000": eight digits.
std::string address_text(uint32_t address);
// Writes "33.6 M": three digits.
std::string count_text(double count);
// Writes "1:42" or "2:03:09".
std::string duration_text(double seconds);

// A word of a command that a POSIX shell takes as it is: in quotes where it holds what the shell reads otherwise.
std::string shell_word(const std::string& word);

// `text` as a terminal may get it: '?' stands for each control character but line breaks, since names that strangers
// chose may hold commands for the terminal. The controls of Unicode are among them, and their bytes outside of UTF-8.
std::string visible(std::string text);

// The one way to a terminal, but for the progress: prints as std::fprintf does what visible() leaves.
[[gnu::format(printf, 2, 3)]] void print(std::FILE* stream, const char* pattern, ...);

// Returns ".png" for "a/b.PNG".
std::string small_ending(const std::string& path);

// Returns `text` with every `from` replaced by `to`.
std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace lumi::tools
