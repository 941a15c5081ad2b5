// SPDX-License-Identifier: MIT
// lumi embed: a field as part of a program.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands/commands.h"
#include "files/embed.h"
#include "files/field_file.h"
#include "files/output_file.h"
#include "files/symbol.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

struct EmbedOptions {
    std::string field, output, symbol, section, incbin;
};

EmbedKind kind_of(const EmbedOptions& options)
{
    const std::filesystem::path extension = std::filesystem::path(options.output).extension();
    if (extension == ".S" || extension == ".s") return EmbedKind::assembler;
    if (extension == ".c") return EmbedKind::array;
    if (extension == ".bin") return EmbedKind::flashed;
    throw UsageError("--output takes a name that ends in .S, .c or .bin, such as field.S");
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

void check_options(const EmbedOptions& options, EmbedKind kind)
{
    if (!options.section.empty() && !is_section(options.section))
        throw UsageError("--section takes letters, digits and . _ $ -, not \"" + options.section + "\"");
    if (!options.section.empty() && kind == EmbedKind::flashed)
        throw UsageError("a .bin has no --section: it is flashed on its own");
    if (!options.incbin.empty() && kind != EmbedKind::assembler) throw UsageError("--incbin is for a .S alone");
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

std::string source_of(const EmbedOptions& options, EmbedKind kind, const EmbedName& name, const FieldFile& field)
{
    if (kind == EmbedKind::assembler) return embed_assembler(name, incbin_of(options));
    if (kind == EmbedKind::array) return embed_array(name, field.bytes(), field.size());
    return {reinterpret_cast<const char*>(field.bytes()), field.size()};
}

void run(const EmbedOptions& options)
{
    const EmbedKind kind = kind_of(options);
    const EmbedName name = {symbol_of(options), options.section};
    check_options(options, kind);
    const std::string header = std::filesystem::path(options.output).replace_extension(".h").string();
    announce_outputs({options.output, header});
    const FieldFile field(options.field);
    field.require_intact();
    const std::string source = source_of(options, kind, name, field);
    const std::string declarations = embed_header(name.symbol, kind, field);
    write_outputs({{options.output, source}, {header, declarations}});
    std::printf("%s, %s: symbol %s, %zu bytes\n", options.output.c_str(), header.c_str(), name.symbol.c_str(),
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
                     "File to write: .S for an assembler, .c for a compiler that has none (Arduino, MSVC), .bin to be "
                     "flashed on its own; the header goes beside it as .h")
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
    command->footer(
        "Example:\n  lumi embed product.lumi -o product.S --symbol product_field\n"
        "  arm-none-eabi-gcc -mcpu=cortex-m4 -c product.S");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
