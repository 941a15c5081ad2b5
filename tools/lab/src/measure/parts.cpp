// SPDX-License-Identifier: MIT
// lumi-lab parts: the parts of the planner's model.
#include "measure/commands.h"
#include "planner/chips.h"

namespace lumi::lab
{

namespace
{

using Json = nlohmann::ordered_json;

Json json_of(const planner::Chip& chip)
{
    return {{"key", chip.key},
            {"title", planner::marked_title(chip)},
            {"core", chip.core},
            {"clock_mhz", chip.clock_mhz},
            {"clocks_per_instruction", chip.clocks_per_instruction},
            {"cache", {{"bytes", chip.cache.bytes}, {"ways", chip.cache.ways}, {"line_bytes", chip.cache.line_bytes}}},
            {"miss_ns", chip.miss_ns},
            {"cores", chip.cores},
            {"remark", chip.remark}};
}

}  // namespace

void add_parts(CLI::App& lab)
{
    CLI::App* command = lab.add_subcommand("parts", "Tell the parts of the model that turns instructions into rates");
    command->callback([] {
        Json json = Json::array();
        for (const planner::Chip& chip : planner::kChipList) json.push_back(json_of(chip));
        print(json);
    });
}

}  // namespace lumi::lab
