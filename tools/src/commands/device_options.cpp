// SPDX-License-Identifier: MIT
#include "commands/device_options.h"

#include "lumi/camera.h"
#include "program/option_checks.h"
#include "terminal/text.h"

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

void add_screen_options(CLI::App& command, host::ScreenSize& screen)
{
    const auto set_size = [&screen](const std::string& text) {
        const auto size = parse_size(text);
        if (!size || size->width_px > kMaxImageSide || size->height_px > kMaxImageSide)
            throw CLI::ValidationError("--screen", "takes WIDTHxHEIGHT such as 466x466, each 1 to " +
                                                       std::to_string(kMaxImageSide) + ", not \"" + text + "\"");
        screen.width_px = size->width_px;
        screen.height_px = size->height_px;
    };
    command
        .add_option_function<std::string>("--screen", set_size,
                                          "Screen of the device, for RAM and frame rates [240x240]")
        ->type_name("WxH");
    command.add_option("--rows", screen.rows, "Rows of a stripe, which the device draws at once")
        ->type_name("N")
        ->check(whole_number(1, kMaxImageSide))
        ->capture_default_str();
}

}  // namespace lumi::tools
