// SPDX-License-Identifier: MIT
// lumi inspect: what a field file holds.
#include <memory>

#include "commands/commands.h"
#include "files/field_report.h"

namespace lumi::tools
{

namespace
{

struct InspectOptions {
    std::string field;
    bool json = false, verify = false;
};

void run(const InspectOptions& options)
{
    const FieldFile file(options.field);
    const FieldReport report = describe_field(file, options.verify);
    const std::string text = options.json ? json_of(report) : text_of(report);
    std::fputs(text.c_str(), stdout);
    if (options.verify) file.require_intact();
}

}  // namespace

void add_inspect(CLI::App& lumi)
{
    auto options = std::make_shared<InspectOptions>();
    CLI::App* command = lumi.add_subcommand("inspect", "Show what a field file holds and where its bytes go");
    command->add_option("FIELD", options->field, "A field file")->required();
    command->add_flag("--json", options->json, "Print JSON");
    command->add_flag("--verify", options->verify, "Check the CRC of every section; exit code 1 if one is damaged");
    command->footer("Example:\n  lumi inspect product.lumi --verify");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
