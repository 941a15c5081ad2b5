// SPDX-License-Identifier: MIT
// Options that name light states, and their weights.
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "draw/draw_surface.h"
#include "files/field_file.h"
#include "lumi/baker/scene.h"

namespace lumi::tools
{

enum class StateWords : uint8_t { names, weights };

// Adds --state NAME, or --state NAME=WEIGHT where weights are chosen: a number from 0 to 1, or three with commas.
void add_state_option(CLI::App& command, std::vector<baker::StateOption>& states, StateWords words);

// Adds --tint NAME, a material whose base colour is chosen when the field is drawn.
void add_tint_option(CLI::App& command, std::vector<std::string>& tints);
// Adds --tint NAME=COLOUR, which chooses it.
void add_colour_option(CLI::App& command, std::vector<baker::StateOption>& colours);

// Adds the light states of a field that are not among them: they are on.
void add_unnamed(const FieldFile& field, std::vector<baker::StateOption>& states);

// The weights of a field's own light states, and the colours of its tints. Throws Failure where it has none of a name.
std::vector<StateValue> values_of(const std::vector<baker::StateOption>& states,
                                  const std::vector<baker::StateOption>& colours, const FieldFile& field);

// Throws Failure where a scene of that file is to be baked with the light state base alone.
void require_other_light(const baker::Scene& scene, const std::string& file);

}  // namespace lumi::tools
