// SPDX-License-Identifier: MIT
// The subcommands of `lumi-lab`. All but `bench` write JSON to standard output.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace lumi::lab
{

void add_bench(CLI::App& lab);
void add_frames(CLI::App& lab);
void add_parts(CLI::App& lab);
void add_work(CLI::App& lab);
void add_draw(CLI::App& lab);
void add_extremes(CLI::App& lab);
void add_surface_extremes(CLI::App& lab);

void print(const nlohmann::ordered_json& json);

// Hundredths: finer digits would mean nothing, and text stays short. Infinity is null.
nlohmann::ordered_json hundredths(double value);

}  // namespace lumi::lab
