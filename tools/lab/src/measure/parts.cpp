// SPDX-License-Identifier: MIT
// lumi-lab parts: the parts of the planner's model, and with --rate the frames a second of a bench's rows.
#include <iostream>

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

// Converts a row's parts from instructions a covered pixel to instructions a frame.
uint64_t of_frame(const Json& row, std::initializer_list<const char*> parts)
{
    double sum = 0;
    for (const char* part : parts) sum += row.at(part).get<double>();
    return static_cast<uint64_t>(sum * row.at("covered_pixels").get<double>());
}

// The rate where both cores prepare, by halves, and draw.
double rate_of_two(const planner::Chip& chip, const Json& row, uint64_t misses)
{
    const uint64_t instructions = row.at("instructions_per_frame");
    const uint64_t alone = of_frame(row, {"palette", "vertices", "lists", "lights"});
    return planner::frames_per_second_of_two(chip, of_frame(row, {"halves"}), instructions - alone, misses);
}

// Adds the frames a second of each part that runs this row's code.
void put_rates(Json& row)
{
    const uint64_t instructions = row.at("instructions_per_frame");
    for (const planner::Chip& chip : planner::kChipList) {
        if (row.at("core") != chip.core) continue;
        const std::string key = chip.key;
        const uint64_t misses = row.at("misses_" + key);
        row["fps_" + key] = hundredths(planner::frames_per_second(chip, instructions, misses));
        if (chip.cores == 2 && row.at("layout") == "surface")
            row["fps2_" + key] = hundredths(rate_of_two(chip, row, misses));
    }
}

}  // namespace

void add_parts(CLI::App& lab)
{
    auto rate = std::make_shared<bool>(false);
    CLI::App* command = lab.add_subcommand("parts", "Tell the parts of the model that turns instructions into rates");
    command->add_flag("--rate", *rate, "Read rows of a bench from standard input and add their rates");
    command->callback([rate] {
        Json json = Json::array();
        if (*rate) {
            json = Json::parse(std::cin);
            for (Json& row : json) put_rates(row);
        } else {
            for (const planner::Chip& chip : planner::kChipList) json.push_back(json_of(chip));
        }
        print(json);
    });
}

}  // namespace lumi::lab
