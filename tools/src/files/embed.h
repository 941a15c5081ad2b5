// SPDX-License-Identifier: MIT
// A field as part of a program: its bytes as assembler, C or a file to be flashed, and a C and C++ header for them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/field_file.h"

namespace lumi::tools
{

// A symbol has letters, digits and underscores, and does not begin with a digit.
bool is_symbol(std::string_view text);
// Returns the nearest symbol to `text`: other characters become underscores.
std::string symbol_from(std::string_view text);
// A section may be named by letters, digits and ._$-, so that it means the same to every assembler and compiler.
bool is_section(std::string_view text);

struct EmbedName {
    std::string symbol;
    std::string section;  // empty: .rodata.SYMBOL in assembler, the compiler's choice in C
};

// GNU assembler text for any target, aligned to 8 bytes, with global labels SYMBOL and SYMBOL_end. `path` is written
// into .incbin as it is.
std::string embed_assembler(const EmbedName& name, const std::string& path);

// Writes the bytes for a C++ compiler, GCC or clang, in a build that has no assembler: a file-scope asm.
std::string embed_cpp(const EmbedName& name, const std::string& path);

// The bytes as an array in C, for compilers that have no .incbin: aligned to 8 bytes.
std::string embed_array(const EmbedName& name, const uint8_t* bytes, size_t size);

enum class EmbedKind {
    assembler,  // bytes from SYMBOL to SYMBOL_end
    cpp,        // the same
    array,      // SYMBOL, an array
    flashed,    // SYMBOL, a pointer, where the address is known; else nothing: the program says where the bytes lie
};

// Declares what a build needs: the bytes, how many, and the view that draws them. `address`: where flashed bytes lie,
// if that is known. `purpose`: a comment, see embed_purpose.h.
std::string embed_header(const std::string& symbol, EmbedKind kind, const FieldFile& field,
                         std::optional<uint32_t> address, const std::string& purpose);

// Whether C or C++ means something else by this word: keywords of any edition, what the headers of an embedded field
// define, the namespaces std and lumi, and names that are reserved for compilers (two underscores, or one and a
// capital).
bool is_taken(std::string_view symbol);

// UF2, the file format that boards with a USB boot loader flash when it is copied onto their drive
// (https://github.com/microsoft/uf2).

enum class Uf2Family : uint32_t {
    rp2040 = 0xE48BFF56,
    rp2350 = 0xE48BFF57,  // "absolute": data at any address
};

// Where the boot loader of a family flashes bytes, as the processor sees them.
struct FlashRange {
    uint32_t begin, end;
};
FlashRange flash_of(Uf2Family family);

// A boot loader erases so much at once. Bytes of other programs in a file's last sector are lost.
inline constexpr uint32_t kUf2SectorBytes = 4096;

// `address` is divisible by kUf2SectorBytes, and address + size at most 2^32.
std::string uf2_of(const uint8_t* bytes, size_t size, uint32_t address, Uf2Family family);

}  // namespace lumi::tools
