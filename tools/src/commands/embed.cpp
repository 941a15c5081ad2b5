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
    std::string field, output, symbol, incbin;
};

std::filesystem::path source_path(const EmbedOptions& options)
{
    const std::filesystem::path source(options.output);
    if (source.extension() != ".S" && source.extension() != ".s")
        throw UsageError("--output takes a name that ends in .S, such as field.S");
    return source;
}

std::string symbol_of(const EmbedOptions& options, const std::filesystem::path& source)
{
    const std::string symbol = options.symbol.empty() ? symbol_from(source.stem().string()) : options.symbol;
    if (!is_symbol(symbol)) throw UsageError("--symbol takes letters, digits and underscores, not \"" + symbol + "\"");
    if (is_taken(symbol))
        throw UsageError("\"" + symbol + "\" has a meaning of its own in C or C++; name the field's bytes otherwise, " +
                         "for instance with --symbol " + symbol + "_field");
    return symbol;
}

void run(const EmbedOptions& options)
{
    const std::filesystem::path source = source_path(options);
    const std::string symbol = symbol_of(options, source);
    const std::string header = std::filesystem::path(source).replace_extension(".h").string();
    announce_outputs({source.string(), header});
    const FieldFile field(options.field);
    field.require_intact();
    const std::string incbin =
        options.incbin.empty() ? std::filesystem::absolute(options.field).lexically_normal().string() : options.incbin;
    write_output(source.string(), embed_source(symbol, incbin));
    write_output(header, embed_header(symbol, field.is_surface() ? "open_surface" : "open_field"));
    std::printf("%s, %s: symbol %s, %zu bytes\n", source.c_str(), header.c_str(), symbol.c_str(), field.size());
}

}  // namespace

void add_embed(CLI::App& lumi)
{
    auto options = std::make_shared<EmbedOptions>();
    CLI::App* command =
        lumi.add_subcommand("embed", "Write an assembler file and a header that make a field part of a program");
    command->add_option("FIELD", options->field, "A field file")->required();
    command->add_option("-o,--output", options->output, "Assembler file to write; the header goes beside it as .h")
        ->type_name("FIELD.S")
        ->required();
    command->add_option("--symbol", options->symbol, "Name of the bytes in C [the output's name without .S]")
        ->type_name("NAME");
    command
        ->add_option("--incbin", options->incbin,
                     "Path of the field to write into the assembler file as it is; a relative one is looked up from "
                     "the compiler's working directory and its -I folders [the absolute path of FIELD]")
        ->type_name("PATH");
    command->footer(
        "Example:\n  lumi embed product.lumi -o product.S --symbol product_field\n"
        "  arm-none-eabi-gcc -mcpu=cortex-m4 -c product.S");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
