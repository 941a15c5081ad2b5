// SPDX-License-Identifier: MIT
#include "files/embed.h"

#include <algorithm>
#include <iterator>

#include "files/field_report.h"
#include "terminal/text.h"

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

// Inside an assembler string.
std::string quoted(const std::string& path)
{
    return replaced(replaced(path, "\\", "\\\\"), "\"", "\\\"");
}

}  // namespace

bool is_symbol(std::string_view text)
{
    return !text.empty() && !is_digit(text.front()) &&
           std::all_of(
               text.begin(), text.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

std::string symbol_from(std::string_view text)
{
    std::string symbol(text);
    for (char& c : symbol)
        if (!is_letter(c) && !is_digit(c)) c = '_';
    return symbol.empty() || is_digit(symbol.front()) ? "_" + symbol : symbol;
}

bool is_section(std::string_view text)
{
    const auto is_sign = [](char c) { return c == '.' || c == '$' || c == '-'; };
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [&](char c) { return is_letter(c) || is_digit(c) || is_sign(c); });
}

namespace
{

// %progbits, not @progbits: in ARM assembler @ begins a comment. The path goes in last: it may hold any text.
std::string bytes_in_assembler(const EmbedName& name, const std::string& path)
{
    const std::string text =
        R"(    .section @SECTION@, "a", %progbits
    .balign 8
    .global @SYMBOL@
    .global @SYMBOL@_end
    .type @SYMBOL@, %object
@SYMBOL@:
    .incbin "@PATH@"
@SYMBOL@_end:
    .size @SYMBOL@, @SYMBOL@_end - @SYMBOL@
    .previous
)";
    const std::string section = name.section.empty() ? ".rodata." + name.symbol : name.section;
    return replaced(replaced(replaced(text, "@SECTION@", section), "@SYMBOL@", name.symbol), "@PATH@", quoted(path));
}

}  // namespace

std::string embed_assembler(const EmbedName& name, const std::string& path)
{
    return R"(/* Written by `lumi embed`. Change the field, not this file. A relative path below is looked up in the compiler's
   folder and in those of -I: give it this file's. */
)" + bytes_in_assembler(name, path) +
           "    .section .note.GNU-stack, \"\", %progbits\n";
}

// quoted() leaves no quotation mark without a backslash before it, so a path cannot end the raw string.
std::string embed_cpp(const EmbedName& name, const std::string& path)
{
    return R"(/* Written by `lumi embed`. Change the field, not this file. A relative path below is looked up in the compiler's
   folder and in those of -I: give it this file's. Compile it without -flto, which loses the symbols of assembler. */
__asm__(R"lumi(
)" + bytes_in_assembler(name, path) +
           ")lumi\");\n";
}

std::string embed_array(const EmbedName& name, const uint8_t* bytes, size_t size)
{
    std::string text = R"(/* Written by `lumi embed`. Change the field, not this file. */
#include <stdint.h>

#ifdef __cplusplus
extern "C" const uint8_t @SYMBOL@[@BYTES@];
#endif

#ifdef _MSC_VER
__declspec(align(8))
#else
__attribute__((aligned(8)@SECTION@))
#endif
const uint8_t @SYMBOL@[@BYTES@] = {)";
    const std::string section = name.section.empty() ? "" : ", section(\"" + name.section + "\")";
    text = replaced(replaced(replaced(text, "@SYMBOL@", name.symbol), "@SECTION@", section), "@BYTES@",
                    std::to_string(size));
    constexpr size_t kPerLine = 32;
    text.reserve(text.size() + 4 * size + size / kPerLine);
    for (size_t k = 0; k < size; ++k) {
        if (k % kPerLine == 0) text += '\n';
        text += std::to_string(bytes[k]) + ',';
    }
    return text + "\n};\n";
}

namespace
{

std::string declaration_of(EmbedKind kind, bool has_address)
{
    if (has_address)
        return R"(/* The bytes of the field lie where they are flashed. */
static const uint8_t* const @SYMBOL@ = (const uint8_t*)@ADDRESS@u;

static inline size_t @SYMBOL@_size(void)
{
    return @BYTES@u;
}
)";
    switch (kind) {
        case EmbedKind::assembler:
        case EmbedKind::cpp:
            return R"(/* The bytes of the field, aligned to 8. */
extern const uint8_t @SYMBOL@[];
extern const uint8_t @SYMBOL@_end[];

static inline size_t @SYMBOL@_size(void)
{
    return (size_t)(@SYMBOL@_end - @SYMBOL@);
}
)";
        case EmbedKind::array:
            return R"(/* The bytes of the field, aligned to 8. */
extern const uint8_t @SYMBOL@[@BYTES@];

static inline size_t @SYMBOL@_size(void)
{
    return @BYTES@u;
}
)";
        case EmbedKind::flashed:
            return R"(/* The bytes of the field lie where the program flashes them, at an address divisible by 4. */
static inline size_t @SYMBOL@_size(void)
{
    return @BYTES@u;
}
)";
    }
    return {};
}

// A header says this of the numbers of parts or of states. Names have numbers from 0 on; those for C stand behind the
// field's symbol and `of_c`.
struct NumberedNames {
    std::vector<std::string> names;
    std::string for_c, count, of_c;  // `count` is an enumerator
    std::string for_cpp, scope;
};

std::string enum_of(const NumberedNames& numbered)
{
    if (numbered.names.empty()) return {};
    std::string text = "\n/* " + numbered.for_c + " */\nenum { @SYMBOL@" + numbered.count;
    for (size_t k = 0; k < numbered.names.size(); ++k)
        text += ", @SYMBOL@" + numbered.of_c + numbered.names[k] + " = " + std::to_string(k);
    return text + " };\n";
}

std::string namespace_of(const NumberedNames& numbered)
{
    if (numbered.names.empty()) return {};
    std::string text = "\n/* " + numbered.for_cpp + " */\nnamespace @SYMBOL@" + numbered.scope + "\n{\n";
    for (size_t k = 0; k < numbered.names.size(); ++k)
        text += "constexpr uint32_t " + numbered.names[k] + " = " + std::to_string(k) + ";\n";
    return text + "}\n";
}

// Identifiers for names, all different.
template <class NameOf>
std::vector<std::string> identifiers(uint32_t count, const std::string& prefix, const NameOf& name_of)
{
    std::vector<std::string> names;
    for (uint32_t number = 0; number < count; ++number) {
        std::string name = symbol_from(name_of(number));
        while (name.find("__") != std::string::npos) name = replaced(name, "__", "_");
        if (is_taken(name)) name = prefix + name;
        const std::string first = name;
        for (int k = 2; std::find(names.begin(), names.end(), name) != names.end(); ++k)
            name = first + "_" + std::to_string(k);
        names.push_back(name);
    }
    return names;
}

NumberedNames parts_of(const SurfaceField& field)
{
    return {identifiers(
                mover_count(field), "part_", [&](uint32_t part) { return name_of_part(field, part); }),
            "Moving parts: lumi::c draws them if it is compiled with LUMI_C_PARTS, and shadows with LUMI_C_SEE_THROUGH."
            "\n   So many, shadows included, take memory.",
            "_moving_parts = " + std::to_string(field.part_count),
            "_part_",
            "Moving parts, for view.turn() and view.slide().",
            "_parts"};
}

NumberedNames states_of(const SurfaceField& field)
{
    return {identifiers(
                field.state_count, "state_", [&](uint32_t state) { return name_of_state(field, state); }),
            "Light states: lumi::c weighs them if it is compiled with LUMI_C_STATES.",
            "_light_states = " + std::to_string(field.state_count),
            "_state_",
            "Light states, for view.set_state().",
            "_states"};
}

}  // namespace

std::string embed_header(const std::string& symbol, EmbedKind kind, const FieldFile& field,
                         std::optional<uint32_t> address, const std::string& purpose)
{
    const std::string text = R"(/* Written by `lumi embed`. Change the field, not this file.
   @PURPOSE@ */
#ifndef LUMI_EMBEDDED_@SYMBOL@
#define LUMI_EMBEDDED_@SYMBOL@

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

@DECLARATION@
/* lumi.h sizes its memory by these. lumi::c draws gloss maps if it is compiled with LUMI_C_GLOSS. */
enum { @SYMBOL@_vertices = @VERTICES@, @SYMBOL@_patches = @PATCHES@, @SYMBOL@_see_through = @SEE_THROUGH@ };
enum { @SYMBOL@_gloss = @GLOSS@, @SYMBOL@_viewed = @VIEWED@ };
@ENUM@
#ifdef __cplusplus
}

/* This draws the field: @SYMBOL@_view<lumi::Screen<240, 240, 16>>, see lumi/view.h. Without a view,
   lumi::@OPENER@(@SYMBOL@, @SYMBOL@_size(), field) opens it. */
#include <@HEADER@>
template <class Screen = lumi::Screen<>, @PARAMETERS@>
using @SYMBOL@_view = @VIEW@;
@NAMESPACE@
/* It takes so much: flash, and RAM for a view and a stripe of its pixels. The stack is not counted. */
constexpr uint32_t @SYMBOL@_flash_bytes = @BYTES@u;
template <class View = @SYMBOL@_view<>>
constexpr uint32_t @SYMBOL@_ram_bytes = sizeof(View) + View::kStripeBytes;
#endif

#endif
)";
    const RendererName renderer = renderer_of(field);
    std::string result = replaced(text, "@DECLARATION@", declaration_of(kind, address.has_value()));
    result = replaced(result, "@ADDRESS@", address_text(address.value_or(0)));
    result = replaced(replaced(result, "@HEADER@", renderer.header), "@PARAMETERS@", renderer.parameters);
    result = replaced(result, "@OPENER@", renderer.opener);
    const SurfaceField none, &counted = field.is_surface() ? field.surface() : none;
    const NumberedNames parts = parts_of(counted), states = states_of(counted);
    result = replaced(result, "@GLOSS@", std::to_string(gloss_count(counted)));
    result = replaced(result, "@VIEWED@", std::to_string(counted.viewed_count));
    result = replaced(result, "@ENUM@", enum_of(parts) + enum_of(states));
    result = replaced(result, "@NAMESPACE@", namespace_of(parts) + namespace_of(states));
    result = replaced(result, "@VERTICES@", std::to_string(counted.vertex_count));
    result = replaced(result, "@PATCHES@", std::to_string(counted.patch_count));
    result = replaced(result, "@SEE_THROUGH@", std::to_string(counted.see_through_count));
    result = replaced(replaced(result, "@VIEW@", renderer.view), "@BYTES@", std::to_string(field.size()));
    return replaced(replaced(result, "@SYMBOL@", symbol), "@PURPOSE@", purpose);
}

namespace
{

// C23 and C++23, in their order; and what <cstddef> and core's headers need. A space stands around each.
constexpr std::string_view kTaken =
    " alignas alignof and and_eq asm atomic_cancel atomic_commit atomic_noexcept auto bitand bitor"
    " bool break case catch char char16_t char32_t char8_t class co_await co_return co_yield compl"
    " concept const const_cast consteval constexpr constinit continue decltype default delete do"
    " double dynamic_cast else enum explicit export extern false float for friend goto if inline int"
    " long mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected"
    " public register reinterpret_cast requires restrict return short signed sizeof static"
    " static_assert static_cast struct switch template this thread_local throw true try typedef"
    " typeid typename typeof typeof_unqual union unsigned using virtual void volatile wchar_t while"
    " xor xor_eq main size_t unix linux lumi std NULL offsetof ptrdiff_t nullptr_t max_align_t ";

bool starts(std::string_view word, std::string_view with)
{
    return word.substr(0, with.size()) == with;
}

bool ends(std::string_view word, std::string_view with)
{
    return word.size() >= with.size() && word.substr(word.size() - with.size()) == with;
}

// C17, 7.1.3: two underscores, or one and a capital.
bool is_for_compilers(std::string_view word)
{
    return word.find("__") != std::string_view::npos ||
           (word.size() > 1 && word[0] == '_' && word[1] >= 'A' && word[1] <= 'Z');
}

// C17, 7.31.10: what <stdint.h> has or may have one day, such as uint8_t and UINT8_MAX.
bool is_for_stdint(std::string_view word)
{
    if (starts(word, "int") || starts(word, "uint")) return ends(word, "_t");
    constexpr std::string_view kOthers[] = {"PTRDIFF_", "SIG_ATOMIC_", "SIZE_", "WCHAR_", "WINT_", "INT", "UINT"};
    const bool is_other = std::any_of(std::begin(kOthers), std::end(kOthers),
                                      [&](std::string_view start) { return starts(word, start); });
    return is_other && (ends(word, "_MAX") || ends(word, "_MIN") || ends(word, "_C") || ends(word, "_WIDTH"));
}

}  // namespace

bool is_taken(std::string_view symbol)
{
    if (symbol.empty()) return false;
    return is_for_compilers(symbol) || is_for_stdint(symbol) ||
           kTaken.find(" " + std::string(symbol) + " ") != std::string_view::npos;
}

namespace
{

constexpr size_t kUf2BlockBytes = 512, kHeaderBytes = 32, kPayloadBytes = 256;  // a page of flash a block
constexpr uint32_t kFirstMagic = 0x0A324655, kSecondMagic = 0x9E5D5157, kLastMagic = 0x0AB16F30;
constexpr uint32_t kHasFamily = 0x2000;

void put(std::string& text, uint32_t word)
{
    for (int shift = 0; shift < 32; shift += 8) text += static_cast<char>(word >> shift & 0xFF);
}

}  // namespace

// The windows of the datasheets: 16 MB behind one chip select, of which an RP2350 has two.
FlashRange flash_of(Uf2Family family)
{
    switch (family) {
        case Uf2Family::rp2040:
            return {0x10000000, 0x11000000};
        case Uf2Family::rp2350:
            return {0x10000000, 0x12000000};
    }
    return {};
}

std::string uf2_of(const uint8_t* bytes, size_t size, uint32_t address, Uf2Family family)
{
    const size_t blocks = (size + kPayloadBytes - 1) / kPayloadBytes;
    std::string text;
    for (size_t k = 0; k < blocks; ++k) {
        const size_t from = k * kPayloadBytes, count = std::min(kPayloadBytes, size - from);
        for (const uint32_t word : {kFirstMagic, kSecondMagic, kHasFamily, address + static_cast<uint32_t>(from),
                                    static_cast<uint32_t>(kPayloadBytes), static_cast<uint32_t>(k),
                                    static_cast<uint32_t>(blocks), static_cast<uint32_t>(family)})
            put(text, word);
        text.append(reinterpret_cast<const char*>(bytes) + from, count);
        text.append(kUf2BlockBytes - kHeaderBytes - count - sizeof kLastMagic, '\0');
        put(text, kLastMagic);
    }
    return text;
}

}  // namespace lumi::tools
