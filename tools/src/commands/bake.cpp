// SPDX-License-Identifier: MIT
// lumi bake: from a scene to a field file.
#include <chrono>
#include <cstdio>
#include <memory>

#include "choice.h"
#include "commands.h"
#include "lumi/baker/bake.h"
#include "lumi/lattice.h"
#include "lumi/tools/failure.h"
#include "lumi/tools/output_file.h"
#include "lumi/tools/progress_printer.h"
#include "lumi/tools/text.h"
#include "scene_options.h"

namespace lumi::tools
{

namespace
{

struct BakeOptions {
    SceneOptions scene;
    baker::BakeSettings settings;
    std::string output, cap;
};

const Choices<format::TexelFormat> kTexelChoices = {{"rgb888", format::TexelFormat::rgb888},
                                                    {"rgb565", format::TexelFormat::rgb565},
                                                    {"palette8", format::TexelFormat::palette8},
                                                    {"luma8", format::TexelFormat::luma8}};

baker::BakeSettings settings_of(const BakeOptions& options)
{
    baker::BakeSettings settings = options.settings;
    settings.threads = options.scene.threads;
    if (options.cap.empty()) return settings;
    const auto used = parse_cap(options.cap, settings.origins);
    if (!used)
        throw UsageError("--cap takes a number of origins from 1 to " + std::to_string(settings.origins) +
                         " or a share such as 50% or 0.5, not \"" + options.cap + "\"");
    settings.used_origins = *used;
    return settings;
}

void bake(const baker::Scene& scene, const baker::BakeSettings& settings, const std::string& target)
{
    ProgressPrinter printer(stderr, stderr_is_terminal());
    try {
        baker::bake_field(scene, settings, target, watch(printer));
    } catch (const baker::Cancelled&) {
        throw Interrupted();
    }
}

double rays_of(const baker::BakeSettings& settings)
{
    const uint32_t rows = settings.used_origins != 0 ? settings.used_origins : settings.origins;
    return static_cast<double>(rows) * settings.directions * settings.samples;
}

void run(const BakeOptions& options)
{
    const auto start = std::chrono::steady_clock::now();
    const baker::BakeSettings settings = settings_of(options);
    const uint64_t bytes = baker::field_file_bytes(settings);
    const std::string target = regular_target(options.output);
    require_writable(target);
    size_t warnings = 0;
    const baker::Scene scene = load_scene(options.scene, warnings);
    bake(scene, settings, target);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    std::printf("%s: %s, %s rays in %s, %zu warnings\n", options.output.c_str(), byte_text(bytes).c_str(),
                count_text(rays_of(settings)).c_str(), duration_text(elapsed.count()).c_str(), warnings);
}

void add_lattice_options(CLI::App& command, BakeOptions& options)
{
    baker::BakeSettings& settings = options.settings;
    const auto sizes = CLI::Range(uint32_t{1}, kMaxLatticeSize);
    command.add_option("--origins", settings.origins, "Points on the near side of the sphere, M")
        ->type_name("M")
        ->check(sizes)
        ->capture_default_str();
    command.add_option("--directions", settings.directions, "Points on the far side, N")
        ->type_name("N")
        ->check(sizes)
        ->capture_default_str();
    command
        .add_option("--cap", options.cap,
                    "Bake the uppermost origins only: a number of them, or a share such as 50% or 0.5; from below the "
                    "object is then not seen [all]")
        ->type_name("F");
    add_choice(command, "--texel", settings.texel, kTexelChoices, "FORMAT",
               "What a ray is stored as: rgb888 (3 bytes), rgb565 (2), palette8 or luma8 (1) [rgb565]");
}

}  // namespace

void add_bake(CLI::App& lumi)
{
    auto options = std::make_shared<BakeOptions>();
    CLI::App* command = lumi.add_subcommand("bake", "Path-trace a scene into a field file");
    add_scene_options(*command, options->scene);
    command->add_option("-o,--output", options->output, "Field file to write")->type_name("FIELD.lumi")->required();
    add_lattice_options(*command, *options);
    command->add_option("--spp", options->settings.samples, "Light paths per texel; more cost time, never bytes")
        ->type_name("S")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--seed", options->settings.seed, "Seed of the random numbers")
        ->type_name("K")
        ->capture_default_str();
    command->footer("The file takes M x N x bytes per texel: " + byte_text(baker::field_file_bytes({})) +
                    " with the defaults.\nCtrl-C cancels and leaves an earlier field untouched.\n"
                    "Example:\n  lumi bake product.obj -o product.lumi --origins 512 --directions 1024 --spp 32");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
