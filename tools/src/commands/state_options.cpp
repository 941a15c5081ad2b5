// SPDX-License-Identifier: MIT
#include "commands/state_options.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "commands/scene_options.h"
#include "lumi/host/nearest_word.h"
#include "lumi/surface/states.h"
#include "terminal/failure.h"

namespace lumi::tools
{
namespace
{

// Names may hold '=': the last one counts.
baker::StateOption weighted(const std::string& option, const std::string& word)
{
    const bool is_colour = option == "--tint";
    const size_t at = std::min(word.rfind('='), word.size());
    const auto weight = at == word.size() ? std::nullopt : colour_of(word.substr(at + 1));
    const bool is_sound = weight && std::all_of(weight->begin(), weight->end(), [](float w) { return w <= 1; });
    if (at == 0 || !is_sound)
        throw CLI::ValidationError(
            option, std::string("takes ") + (is_colour ? "NAME=COLOUR with a colour" : "NAME=WEIGHT with a weight") +
                        " from 0 to 1, or three as in " + (is_colour ? "shell=0.6,0.1,0.1" : "lamp=1,0.8,0.5") +
                        ", not \"" + word + "\"");
    return {word.substr(0, at), *weight};
}

uint16_t q12_of(float weight)
{
    return static_cast<uint16_t>(std::lround(weight * static_cast<float>(kFullWeight)));
}

}  // namespace

void add_state_option(CLI::App& command, std::vector<baker::StateOption>& states, StateWords words)
{
    const bool has_weight = words == StateWords::weights;
    command
        .add_option_function<std::vector<std::string>>(
            "--state",
            [&states, has_weight](const std::vector<std::string>& texts) {
                for (const std::string& text : texts)
                    states.push_back(has_weight ? weighted("--state", text) : baker::StateOption{text});
            },
            has_weight ? "Dim lights, or give them a colour: the weight of a light state, 0 to 1 of its linear light, "
                         "or three for red, green and blue [1]"
                       : "A light state, whose weight is chosen when the field is drawn: a lamp's node, a material "
                         "that shines, or sky; all else is the state base")
        ->type_name(has_weight ? "NAME=WEIGHT" : "NAME")
        ->expected(1)
        ->take_all();
}

void add_tint_option(CLI::App& command, std::vector<std::string>& tints)
{
    command
        .add_option(
            "--tint", tints,
            "A material whose base colour is chosen when the field is drawn, in place of light states; until then "
            "it is that of the model")
        ->type_name("NAME")
        ->expected(1)
        ->take_all();
}

void add_colour_option(CLI::App& command, std::vector<baker::StateOption>& colours)
{
    command
        .add_option_function<std::vector<std::string>>(
            "--tint",
            [&colours](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) colours.push_back(weighted("--tint", text));
            },
            "The base colour of a material: linear light, 0 to 1, a number or three as in shell=0.6,0.1,0.1")
        ->type_name("NAME=COLOUR")
        ->expected(1)
        ->take_all();
}

namespace
{

// A firmware chooses the weights of these.
struct Kind {
    bool is_tint;
    const char *title, *option, *value;
};
constexpr Kind kLight = {false, "light state", "--state", "WEIGHT"}, kTint = {true, "tint", "--tint", "COLOUR"};

std::vector<std::string> names_of(const FieldFile& field)
{
    std::vector<std::string> names;
    for (uint32_t k = 0; field.is_surface() && k < field.surface().state_count; ++k) {
        const StateName name = state_name(field.surface(), k);
        names.emplace_back(name.text, name.bytes);
    }
    return names;
}

[[noreturn]] void fail_unknown(const std::string& name, const Kind& kind, const FieldFile& field)
{
    const std::vector<std::string> all = names_of(field);
    std::vector<std::string> names;
    std::string list;
    for (uint32_t k = 0; k < all.size(); ++k) {
        if (is_tint(field.surface(), k) != kind.is_tint) continue;
        names.push_back(all[k]);
        list += (list.empty() ? "" : ", ") + all[k];
    }
    throw Failure(field.path(),
                  std::string("no ") + kind.title + " of it is named '" + name + "'" + host::meant(name, names),
                  names.empty() ? std::string("it has none; bake it with ") + kind.option : "choose among: " + list);
}

uint32_t number_of(const std::string& name, const Kind& kind, const FieldFile& field)
{
    const std::vector<std::string> names = names_of(field);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) fail_unknown(name, kind, field);
    const auto number = static_cast<uint32_t>(found - names.begin());
    const Kind& own = is_tint(field.surface(), number) ? kTint : kLight;
    if (own.is_tint != kind.is_tint)
        throw Failure(field.path(), "'" + name + "' is a " + own.title + " of it, not a " + kind.title,
                      std::string("write ") + own.option + " " + name + "=" + own.value);
    return number;
}

}  // namespace

void add_unnamed(const FieldFile& field, std::vector<baker::StateOption>& states)
{
    const std::vector<std::string> names = names_of(field);
    for (uint32_t k = 0; k < names.size(); ++k) {
        const auto has_name = [&](const baker::StateOption& state) { return state.name == names[k]; };
        if (!is_tint(field.surface(), k) && std::none_of(states.begin(), states.end(), has_name))
            states.push_back({names[k]});
    }
}

std::vector<StateValue> values_of(const std::vector<baker::StateOption>& states,
                                  const std::vector<baker::StateOption>& colours, const FieldFile& field)
{
    std::vector<StateValue> values;
    const auto add = [&](const std::vector<baker::StateOption>& options, const Kind& kind) {
        for (const baker::StateOption& option : options)
            values.push_back({number_of(option.name, kind, field),
                              {q12_of(option.weight[0]), q12_of(option.weight[1]), q12_of(option.weight[2])}});
    };
    add(states, kLight);
    add(colours, kTint);
    return values;
}

void require_other_light(const baker::Scene& scene, const std::string& file)
{
    if (scene.light_states().size() == 1)
        throw Failure(file, "the light state 'base' alone is all of the light",
                      "name another light by --state, too; base is the rest");
}

}  // namespace lumi::tools
