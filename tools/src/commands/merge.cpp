// SPDX-License-Identifier: MIT
// lumi merge: from the shards of a bake to its field.
#include "lumi/baker/merge.h"

#include <cstdio>
#include <memory>

#include "commands/commands.h"
#include "files/output_file.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

struct MergeOptions {
    std::vector<std::string> shards;
    std::string output;
};

baker::MergedField merge(const MergeOptions& options, const std::string& target)
{
    const Waiting waiting("joining shards");
    try {
        return baker::merge_shards(
            {options.shards.begin(), options.shards.end()}, target,
            [] { return !interrupt_flag().load(std::memory_order_relaxed); });
    } catch (const baker::Cancelled&) {
        throw Interrupted();
    } catch (const baker::MergeError& error) {
        // All but the last here, the last as the command's own message.
        for (size_t k = 0; k + 1 < error.problems.size(); ++k) print(stderr, "lumi: %s\n", error.problems[k].c_str());
        throw baker::BakeError(error.problems.back());
    }
}

void run(const MergeOptions& options)
{
    const std::string target = field_target(options.output);
    const baker::MergedField field = merge(options, target);
    const bool surface = field.origins == 0;
    const std::string rays =
        surface ? "" : std::to_string(field.origins) + " x " + std::to_string(field.directions) + " rays ";
    print(stdout, "%s: %s, %sfrom %u shards\n", options.output.c_str(), byte_text(field.bytes).c_str(), rays.c_str(),
          field.shards);
}

}  // namespace

void add_merge(CLI::App& lumi)
{
    auto options = std::make_shared<MergeOptions>();
    CLI::App* command = lumi.add_subcommand("merge", "Join the shards of a bake into its field");
    command->add_option("SHARD", options->shards, "All files that `lumi bake --shard` wrote, in any order")->required();
    command->add_option("-o,--output", options->output, "Field file to write")->type_name("FIELD.lumi")->required();
    command->footer(
        "The field is the one that a bake on one machine writes, bit for bit. Missing, double, foreign, stale and\n"
        "damaged shards are named, and nothing is written.\n"
        "Example:\n  lumi merge product.lumi.*.shard -o product.lumi");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
