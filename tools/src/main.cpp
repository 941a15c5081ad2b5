// SPDX-License-Identifier: MIT
// The `lumi` command line: subcommands in commands/, plug-ins in folders of their own.
#include "commands/commands.h"
#include "lumi_version.h"
#include "program/plugin.h"
#include "program/program.h"

namespace
{

void describe(CLI::App& lumi)
{
    using namespace lumi::tools;
    lumi.description("Bakes path-traced scenes into fields for microcontrollers, and draws, measures and embeds them.");
    lumi.set_version_flag("--version", lumi_version::kText);
    lumi.footer(
        "Exit codes: 0 done, 1 failed, 2 wrong call, 130 interrupted.\n"
        "Example:\n  lumi bake product.obj -o product.lumi && lumi render product.lumi -o product.png");
    for (const auto add :
         {add_bake, add_merge, add_render, add_view, add_reference, add_compare, add_report, add_inspect, add_embed})
        add(lumi);
    for (const Plugin& plugin : plugins()) plugin.add_subcommand(lumi);
}

}  // namespace

int main(int argc, char** argv)
{
    return lumi::tools::run_program("lumi", describe, argc, argv);
}
