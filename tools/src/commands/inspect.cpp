// SPDX-License-Identifier: MIT
// lumi inspect: what a field file holds.
#include <memory>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "commands/rates.h"
#include "files/field_report.h"

namespace lumi::tools
{

namespace
{

struct InspectOptions {
    std::string field;
    bool json = false, verify = false, rates = false;
};

// The report with "frames_per_second", by mode and part.
std::string with_rates(const std::string& report, const FieldFile& file)
{
    auto json = nlohmann::ordered_json::parse(report);
    for (const ModeRates& mode : rates_of(file))
        for (const planner::PartRate& part : mode.parts)
            json["frames_per_second"][mode.mode][part.chip->key] = part.mean;
    return json.dump(2) + "\n";
}

void run(const InspectOptions& options)
{
    const FieldFile file(options.field);
    std::string text = options.json ? report_json(file, options.verify) : report_text(file, options.verify);
    if (options.rates) text = options.json ? with_rates(text, file) : text + rates_text(file);
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
    command->add_flag("--rates", options->rates, "How fast named parts draw it in each mode, by a model");
    command->footer("Example:\n  lumi inspect product.lumi --verify");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
