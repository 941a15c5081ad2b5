// SPDX-License-Identifier: MIT
#include "commands/part_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "lumi/fixed.h"
#include "lumi/host/nearest_word.h"
#include "program/option_checks.h"
#include "terminal/failure.h"

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

baker::PartOptions part_of(const std::string& word, PartWords words)
{
    const auto fail = [&](const std::string& takes) {
        throw CLI::ValidationError("--part", "takes " + takes + ", not \"" + word + "\"");
    };
    const std::string form = words == PartWords::motion
                                 ? "NAME:AXIS or NAME:AXIS@X,Y,Z, for instance second_hand:z"
                                 : "NAME=DEGREES or NAME:AXIS=DEGREES, for instance second_hand=-90";
    baker::PartOptions part;
    std::string text = word;
    bool has_value = false;
    if (words != PartWords::motion) {
        std::string name = text;
        const auto behind = take_behind(name, '=');
        const auto value = behind ? number_of(*behind) : std::nullopt;
        if (behind && !value && behind->find(':') == std::string::npos) fail(form);
        if (value) {
            part.value = *value;
            text = name;
            has_value = true;
        }
    }
    part.name = text;
    if (auto axis = take_behind(part.name, ':')) {
        if (const auto pivot = take_behind(*axis, '@')) {
            part.pivot = vector_of(*pivot);
            if (!part.pivot) fail("a pivot X,Y,Z of three numbers behind @");
        }
        part.axis = axis->find(',') == std::string::npos ? baker::axis_named(*axis) : vector_of(*axis);
        const bool is_name = has_value && !part.pivot;  // of a part that a scene file gives its axis
        if (!part.axis && !is_name) fail("an axis x, y, z, -x, -y, -z or three numbers behind the last ':'");
        if (!part.axis) part.name = text;
    }
    if (part.name.empty() || (words == PartWords::motion && !part.axis)) fail(form);
    return part;
}

PartPose part_pose_of(const std::string& word)
{
    PartPose pose = {word};
    const std::string values = take_behind(pose.name, '=').value_or("");
    const size_t dots = values.find("..");
    const auto from = number_of(values.substr(0, dots));
    const auto to = dots == std::string::npos ? from : number_of(values.substr(dots + 2));
    if (pose.name.empty() || !from || !to)
        throw CLI::ValidationError(
            "--part", "takes NAME=DEGREES, for instance second_hand=-90, or NAME=FROM..TO, not \"" + word + "\"");
    pose.from = *from;
    pose.to = *to;
    return pose;
}

template <class Value, class Read>
void add_option(CLI::App& command, std::vector<Value>& values, const Read& read, const char* help, const char* form)
{
    command
        .add_option_function<std::vector<std::string>>(
            "--part",
            [&values, read](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) values.push_back(read(text));
            },
            help)
        ->type_name(form)
        ->expected(1)
        ->take_all();
}

}  // namespace

void add_part_option(CLI::App& command, std::vector<baker::PartOptions>& parts, PartWords words)
{
    const bool has_pose = words == PartWords::motion_and_pose;
    add_option(
        command, parts, [words](const std::string& text) { return part_of(text, words); },
        has_pose ? "A part that turns, as in lumi bake, and its pose [at rest]"
                 : "A part that turns, by the name of its object, group or node. AXIS is x, y or z of a glTF node, or "
                   "three numbers; @X,Y,Z is a point of it, needed where files have no nodes",
        has_pose ? "NAME:AXIS=DEGREES" : "NAME:AXIS");
}

void add_pose_option(CLI::App& command, std::vector<PartPose>& poses)
{
    add_option(command, poses, part_pose_of,
               "Turn a part to this angle, or slide it so far in the scene's units [at rest]; FROM..TO moves it over "
               "the views of a turntable",
               "NAME=DEGREES");
}

std::vector<PartValue> values_of(const std::vector<PartPose>& poses, const FieldFile& field, double done)
{
    constexpr double kTurn = 360;
    std::vector<std::string> names;
    for (uint32_t k = 0; field.is_surface() && k < mover_count(field.surface()); ++k) {
        const PartName name = part_name(field.surface(), k);
        names.emplace_back(name.text, name.bytes);
    }
    std::vector<PartValue> values;
    for (const PartPose& part : poses) {
        const auto found = std::find(names.begin(), names.end(), part.name);
        if (found == names.end()) {
            std::string list;
            for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
            throw Failure(field.path(), "no part of it is named '" + part.name + "'" + host::meant(part.name, names),
                          names.empty() ? "nothing in it moves; bake it with --part" : "choose among: " + list);
        }
        const auto number = static_cast<uint32_t>(found - names.begin());
        const double pose = part.from + (part.to - part.from) * done;
        const double offset = pose / static_cast<double>(field.sphere().radius),
                     turns = std::remainder(pose / kTurn, 1);
        const double value = part_motion(field.surface(), number).slides ? offset * kOneQ20 : turns * 0x1p32;
        values.push_back({number, static_cast<uint32_t>(std::llround(std::clamp(value, -0x1p31, 0x1p31)))});
    }
    return values;
}

}  // namespace lumi::tools
