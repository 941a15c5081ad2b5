// SPDX-License-Identifier: MIT
// `lumi-lab`: what only we run, to measure or prove the project. Subcommands in measure/.
#include <cmath>
#include <cstdio>

#include "measure/commands.h"
#include "program/program.h"

namespace lumi::lab
{

void print(const nlohmann::ordered_json& json)
{
    std::printf("%s\n", json.dump(1).c_str());
}

nlohmann::ordered_json hundredths(double value)
{
    return std::isinf(value) ? nlohmann::ordered_json() : nlohmann::ordered_json(std::round(value * 100) / 100);
}

}  // namespace lumi::lab

int main(int argc, char** argv)
{
    const auto describe = [](CLI::App& lab) {
        using namespace lumi::lab;
        lab.description("Measures the project, above all frames on emulated boards.");
        for (const auto add :
             {add_bench, add_frames, add_parts, add_work, add_draw, add_extremes, add_surface_extremes})
            add(lab);
    };
    return lumi::tools::run_program("lumi-lab", describe, argc, argv);
}
