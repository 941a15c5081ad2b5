// SPDX-License-Identifier: MIT
#include "commands/part_options.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "program/option_checks.h"

namespace lumi::tools
{
namespace
{

std::optional<double> number_of(const std::string& word)
{
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool sound = error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
    return sound ? std::optional(value) : std::nullopt;
}

std::optional<std::array<double, 3>> vector_of(const std::string& text)
{
    std::array<double, 3> vector{};
    size_t begin = 0;
    for (size_t k = 0; k < 3; ++k) {
        const size_t end = k == 2 ? text.size() : text.find(',', begin);
        const auto number = end == std::string::npos ? std::nullopt : number_of(text.substr(begin, end - begin));
        if (!number) return std::nullopt;
        vector[k] = *number;
        begin = end + 1;
    }
    return vector;
}

// Cuts what lies behind the last of these characters off the text; nothing if there is none.
std::optional<std::string> take_behind(std::string& text, char mark)
{
    const size_t at = text.rfind(mark);
    if (at == std::string::npos) return std::nullopt;
    const std::string behind = text.substr(at + 1);
    text.resize(at);
    return behind;
}

baker::PartOptions part_of(const std::string& word, PartPose pose)
{
    const auto fail = [&](const std::string& takes) {
        throw CLI::ValidationError("--part", "takes " + takes + ", not \"" + word + "\"");
    };
    const std::string form = pose == PartPose::none ? "NAME:AXIS or NAME:AXIS@X,Y,Z, for instance second_hand:z"
                                                    : "NAME=DEGREES or NAME:AXIS=DEGREES, for instance second_hand=-90";
    baker::PartOptions part;
    std::string text = word;
    if (pose == PartPose::optional) {
        std::string name = text;
        const auto behind = take_behind(name, '=');
        const auto value = behind ? number_of(*behind) : std::nullopt;
        if (behind && !value && behind->find(':') == std::string::npos) fail(form);
        if (value) {
            part.value = *value;
            text = name;
        }
    }
    if (auto axis = take_behind(text, ':')) {
        if (const auto pivot = take_behind(*axis, '@')) {
            part.pivot = vector_of(*pivot);
            if (!part.pivot) fail("a pivot X,Y,Z of three numbers behind @");
        }
        part.axis = axis->find(',') == std::string::npos ? baker::axis_named(*axis) : vector_of(*axis);
        if (!part.axis) fail("an axis x, y, z, -x, -y, -z or three numbers behind the last ':'");
    }
    part.name = text;
    if (part.name.empty() || (pose == PartPose::none && !part.axis)) fail(form);
    return part;
}

}  // namespace

void add_part_option(CLI::App& command, std::vector<baker::PartOptions>& parts, PartPose pose)
{
    const std::string pivot =
        "; AXIS is x, y or z of a glTF node, or three numbers; @X,Y,Z is a point of it, "
        "needed where files have no nodes";
    command
        .add_option_function<std::vector<std::string>>(
            "--part",
            [&parts, pose](const std::vector<std::string>& words) {
                for (const std::string& word : words) parts.push_back(part_of(word, pose));
            },
            pose == PartPose::none ? "A part that turns, by the name of its object, group or node" + pivot
                                   : "A part that turns, as in lumi bake, and its pose")
        ->type_name(pose == PartPose::none ? "NAME:AXIS" : "NAME:AXIS=DEGREES")
        ->expected(1)
        ->take_all();
}

}  // namespace lumi::tools
