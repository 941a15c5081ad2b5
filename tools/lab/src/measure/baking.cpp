// SPDX-License-Identifier: MIT
// lumi-lab convergence, adaptive, threads and memory: what the baker costs.
#include <memory>

#include "baking/measurements.h"
#include "measure/commands.h"

namespace lumi::lab
{

namespace
{

struct Measurement {
    const char *name, *what, *count;
    nlohmann::ordered_json (*run)(const char* scene, unsigned count);
};

constexpr Measurement kMeasurements[] = {
    {"convergence", "Error against the number of light paths", "ROWS", baker::bench::convergence},
    {"adaptive", "What adaptive sampling leaves out, and its error", "TEXELS", baker::bench::adaptive},
    {"threads", "Paths a second against the number of threads", "ROWS", baker::bench::thread_rates}};

struct Words {
    std::string scene;
    unsigned count = 0;
};

}  // namespace

void add_baking(CLI::App& lab)
{
    for (const Measurement& measurement : kMeasurements) {
        auto words = std::make_shared<Words>();
        CLI::App* command = lab.add_subcommand(measurement.name, measurement.what);
        command->add_option("SCENE", words->scene, "A scene file")->required();
        command->add_option(measurement.count, words->count, "How much is traced")->required();
        command->callback([words, run = measurement.run] { print(run(words->scene.c_str(), words->count)); });
    }
    auto triangles = std::make_shared<unsigned>(0);
    CLI::App* command = lab.add_subcommand("memory", "Memory of a scene of that many triangles");
    command->add_option("TRIANGLES", *triangles, "Triangles of a mesh that is made up")->required();
    command->callback([triangles] { print(baker::bench::memory(*triangles)); });
}

}  // namespace lumi::lab
