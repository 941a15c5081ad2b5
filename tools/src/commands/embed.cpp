// SPDX-License-Identifier: MIT
// lumi embed: a field as part of a program.
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands/commands.h"
#include "files/embed.h"
#include "files/embed_purpose.h"
#include "files/field_file.h"
#include "files/output_file.h"
#include "program/option_checks.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

struct EmbedOptions {
    std::string field, output, symbol, section, incbin, address;
    Uf2Family family = Uf2Family::rp2040;
};

bool is_uf2(const EmbedOptions& options)
{
    return std::filesystem::path(options.output).extension() == ".uf2";
}

EmbedKind kind_of(const EmbedOptions& options)
{
    const std::filesystem::path extension = std::filesystem::path(options.output).extension();
    if (extension == ".S" || extension == ".s") return EmbedKind::assembler;
    if (extension == ".cpp") return EmbedKind::cpp;
    if (extension == ".c") return EmbedKind::array;
    if (extension == ".bin" || extension == ".uf2") return EmbedKind::flashed;
    throw UsageError("--output takes a name that ends in .S, .cpp, .c, .bin or .uf2, such as field.S");
}

std::string symbol_of(const EmbedOptions& options)
{
    const std::string stem = std::filesystem::path(options.output).stem().string();
    const std::string symbol = options.symbol.empty() ? symbol_from(stem) : options.symbol;
    if (!is_symbol(symbol)) throw UsageError("--symbol takes letters, digits and underscores, not \"" + symbol + "\"");
    if (is_taken(symbol))
        throw UsageError("\"" + symbol + "\" has a meaning of its own in C or C++; name the field's bytes otherwise, " +
                         "for instance with --symbol " + symbol + "_field");
    return symbol;
}

constexpr unsigned kFieldAlignment = 8;

unsigned alignment_of(const EmbedOptions& options)
{
    return is_uf2(options) ? kUf2SectorBytes : kFieldAlignment;
}

// A number divisible by `alignment`, with room for the field below 2^32.
uint32_t parsed_address(const std::string& text, unsigned alignment, size_t bytes)
{
    char* end = nullptr;
    errno = 0;
    const unsigned long long address = std::strtoull(text.c_str(), &end, 0);
    const bool fits = std::isdigit(static_cast<unsigned char>(text.front())) && *end == 0 && errno == 0 &&
                      address <= UINT32_MAX && bytes <= UINT32_MAX - address;
    if (!fits || address % alignment != 0)
        throw UsageError("--address takes a number divisible by " + std::to_string(alignment) +
                         ", with room for the field below 2^32, such as 0x10100000, not \"" + text + "\"");
    return static_cast<uint32_t>(address);
}

void check_options(const EmbedOptions& options, EmbedKind kind)
{
    if (!options.section.empty() && !is_section(options.section))
        throw UsageError("--section takes letters, digits and . _ $ -, not \"" + options.section + "\"");
    if (!options.section.empty() && kind == EmbedKind::flashed)
        throw UsageError("a .bin or .uf2 has no --section: it is flashed on its own");
    if (!options.address.empty() && kind != EmbedKind::flashed)
        throw UsageError("--address is for a .bin or .uf2 alone");
    if (!options.address.empty()) parsed_address(options.address, alignment_of(options), 0);
    if (options.address.empty() && is_uf2(options))
        throw UsageError("a .uf2 needs --address, where its bytes are flashed, such as 0x10100000");
    if (!options.incbin.empty() && kind != EmbedKind::assembler && kind != EmbedKind::cpp)
        throw UsageError("--incbin is for a .S or .cpp alone");
}

// The boot loader writes to the family's flash alone, in whole sectors, and a program begins in the first of them.
void require_in_flash(const EmbedOptions& options, uint32_t address, size_t bytes)
{
    const FlashRange flash = flash_of(options.family);
    const size_t sectors = (bytes + kUf2SectorBytes - 1) / kUf2SectorBytes,
                 room = (flash.end - flash.begin) / kUf2SectorBytes - 1;
    const std::string where = "--address " + options.address + ": ";
    if (sectors > room)
        throw UsageError(where + "the field has " + byte_text(bytes) +
                         ", more than the board's flash behind a program");
    const auto last = static_cast<uint32_t>(flash.end - sectors * kUf2SectorBytes);
    const std::string mend = "; the field goes behind the program, from " +
                             address_text(flash.begin + kUf2SectorBytes) + " to " + address_text(last) +
                             ", such as 0x10100000";
    if (address == flash.begin) throw UsageError(where + "the program lies there and would be lost" + mend);
    if (address < flash.begin || address > last)
        throw UsageError(where + "the board's flash is " + address_text(flash.begin) + " to " +
                         address_text(flash.end - 1) + mend + ". For another chip write a .bin");
}

// Where the bytes are flashed; nothing if that is not said.
std::optional<uint32_t> address_of(const EmbedOptions& options, size_t bytes)
{
    if (options.address.empty()) return std::nullopt;
    const uint32_t address = parsed_address(options.address, alignment_of(options), bytes);
    if (is_uf2(options)) require_in_flash(options, address, bytes);
    return address;
}

// How the assembler file names the field: from its own folder, so that both can move together.
std::string incbin_of(const EmbedOptions& options)
{
    if (!options.incbin.empty()) return options.incbin;
    const std::filesystem::path field = std::filesystem::absolute(options.field).lexically_normal();
    const std::filesystem::path folder = std::filesystem::absolute(options.output).lexically_normal().parent_path();
    const std::filesystem::path relative = field.lexically_relative(folder);
    return (relative.empty() ? field : relative).generic_string();
}

std::string source_of(const EmbedOptions& options, EmbedKind kind, const EmbedName& name, const FieldFile& field,
                      std::optional<uint32_t> address)
{
    if (kind == EmbedKind::assembler) return embed_assembler(name, incbin_of(options));
    if (kind == EmbedKind::cpp) return embed_cpp(name, incbin_of(options));
    if (kind == EmbedKind::array) return embed_array(name, field.bytes(), field.size());
    if (is_uf2(options)) return uf2_of(field.bytes(), field.size(), *address, options.family);
    return {reinterpret_cast<const char*>(field.bytes()), field.size()};
}

void run(const EmbedOptions& options)
{
    const EmbedKind kind = kind_of(options);
    const EmbedName name = {symbol_of(options), options.section};
    check_options(options, kind);
    const std::string header = std::filesystem::path(options.output).replace_extension(".h").string();
    announce_outputs({options.output, header});
    std::optional<Waiting> waiting(std::in_place, "embedding");
    const FieldFile field(options.field);
    field.require_intact();
    const std::optional<uint32_t> address = address_of(options, field.size());
    const std::string source = source_of(options, kind, name, field, address);
    const std::string purpose =
        embed_purpose(std::filesystem::path(options.field).filename().string(), name.symbol, kind, address);
    require_same_purpose(header, options.output, purpose);
    const std::string declarations = embed_header(name.symbol, kind, field, address, purpose);
    write_outputs({{options.output, source}, {header, declarations}});
    waiting.reset();
    print(stdout, "%s, %s: symbol %s, %zu bytes\n", options.output.c_str(), header.c_str(), name.symbol.c_str(),
          field.size());
}

}  // namespace

void add_embed(CLI::App& lumi)
{
    auto options = std::make_shared<EmbedOptions>();
    CLI::App* command =
        lumi.add_subcommand("embed", "Write a field as part of a program: its bytes, and a header that tells all else");
    command->add_option("FIELD", options->field, "A field file")->required();
    command
        ->add_option("-o,--output", options->output,
                     "File to write: .S for an assembler, .cpp for GCC or clang without one, .c for other compilers "
                     "and Arduino, .bin or .uf2 to be flashed on its own; the header goes beside it as .h")
        ->type_name("FIELD.S")
        ->required();
    command->add_option("--symbol", options->symbol, "Name of the bytes in C [the output's name without .S]")
        ->type_name("NAME");
    command
        ->add_option("--section", options->section, "Section of the bytes, such as .flashdata.field or .qspi [.rodata]")
        ->type_name("NAME");
    command
        ->add_option("--incbin", options->incbin,
                     "Path of the field to write into the assembler file as it is; a relative one is looked up from "
                     "the compiler's working directory and its -I folders [from the output's folder]")
        ->type_name("PATH");
    command
        ->add_option("--address", options->address,
                     "Where a .bin or .uf2 is flashed, as the processor sees it; the header then says it too")
        ->type_name("ADDRESS");
    add_choice<Uf2Family>(*command, "--family", options->family,
                          {{"rp2040", Uf2Family::rp2040}, {"rp2350", Uf2Family::rp2350}},
                          "The board of a .uf2 [rp2040]");
    command->footer(
        "Example:\n  lumi embed product.lumi -o product.S --symbol product_field\n"
        "  arm-none-eabi-gcc -mcpu=cortex-m4 -c product.S");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
