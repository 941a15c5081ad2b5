// SPDX-License-Identifier: MIT
#include "commands/pace_option.h"

namespace lumi::tools
{

void add_pace_option(CLI::App& command, std::vector<planner::Pace>& paces, const std::string& description)
{
    const auto set = [&paces](const std::vector<std::string>& words) {
        for (const std::string& word : words) {
            const auto pace = planner::parse_pace(word);
            if (!pace)
                throw CLI::ValidationError("--for",
                                           "takes parts with or without a frame rate, such as rp2040 or "
                                           "rp2040@30fps, with " +
                                               planner::chip_names() + ", not \"" + word + "\"");
            paces.push_back(*pace);
        }
    };
    command.add_option_function<std::vector<std::string>>("--for", set, description + ": " + planner::chip_names())
        ->delimiter(',')
        ->type_name("PART[@RATEfps],...");
}

}  // namespace lumi::tools
