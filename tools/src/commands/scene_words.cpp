// SPDX-License-Identifier: MIT
#include "commands/scene_words.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "terminal/text.h"

namespace lumi::tools
{
namespace
{

// Those that mean the same in `lumi bake`, word for word.
constexpr std::array kSame = {"--up",       "--iso",     "--pieces", "--sky",
                              "--exposure", "--colours", "--frame",  "--animation"};

// A word that begins with '-' would be another option.
std::string option_text(const std::string& name, const std::string& value)
{
    return name + (value.compare(0, 1, "-") == 0 ? "=" : " ") + shell_word(value) + " ";
}

std::string vector_text(const std::array<double, 3>& vector)
{
    std::string text;
    for (const double number : vector) {
        std::array<char, 32> digits{};
        std::to_chars(digits.begin(), digits.end() - 1, number);  // 24 characters at most
        text += (text.empty() ? "" : ",") + std::string(digits.data());
    }
    return text;
}

std::string axis_text(const std::array<double, 3>& axis)
{
    for (const char* name : {"x", "y", "z", "-x", "-y", "-z"})
        if (axis == *baker::axis_named(name)) return name;
    return vector_text(axis);
}

// A part without an axis stands in the scene file.
std::string part_text(const baker::PartOptions& part)
{
    if (!part.axis) return "";
    const std::string pivot = part.pivot ? "@" + vector_text(*part.pivot) : "";
    return option_text("--part", part.name + ":" + axis_text(*part.axis) + pivot);
}

}  // namespace

bool has_choices(const SceneOptions& options)
{
    const auto is_posed = [](const baker::PartOptions& part) { return part.value != 0; };
    const auto is_dimmed = [](const baker::StateOption& state) { return state.weight != baker::StateOption().weight; };
    return std::any_of(options.parts.begin(), options.parts.end(), is_posed) ||
           std::any_of(options.states.begin(), options.states.end(), is_dimmed) || !options.base_colours.empty();
}

SceneOptions without_choices(SceneOptions options)
{
    for (baker::PartOptions& part : options.parts) part.value = 0;
    for (baker::StateOption& state : options.states) state = {state.name};
    for (const baker::StateOption& colour : options.base_colours) options.tints.push_back(colour.name);
    options.base_colours.clear();
    return options;
}

std::string scene_words(const CLI::App& command, const SceneOptions& options)
{
    std::string words;
    for (const char* name : kSame)
        if (command.count(name) > 0) words += option_text(name, command.get_option(name)->results().back());
    const SceneOptions baked = without_choices(options);
    for (const baker::PartOptions& part : baked.parts) words += part_text(part);
    for (const baker::StateOption& state : baked.states) words += option_text("--state", state.name);
    for (const std::string& tint : baked.tints) words += option_text("--tint", tint);
    return words;
}

}  // namespace lumi::tools
