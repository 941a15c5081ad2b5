// SPDX-License-Identifier: MIT
#include "scene_options.h"

#include <cstdio>

#include "choice.h"

namespace lumi::tools
{

void add_scene_options(CLI::App& command, SceneOptions& options)
{
    command.add_option("SCENE", options.path, "An OBJ file; its MTL files and textures are found beside it")
        ->required();
    add_choice<baker::UpAxis>(command, "--up", options.up, {{"y", baker::UpAxis::y}, {"z", baker::UpAxis::z}}, "y|z",
                              "The scene's vertical axis [y]");
    command.add_option("--threads", options.threads, "Threads to use [all]; the result is the same for any number")
        ->type_name("T");
}

baker::Scene load_scene(const SceneOptions& options, size_t& warnings)
{
    std::vector<std::string> lines;
    baker::LoadOptions load;
    load.up = options.up;
    baker::Scene scene = baker::load_scene(options.path, load, lines);
    for (const std::string& line : lines) std::fprintf(stderr, "lumi: warning: %s\n", line.c_str());
    warnings = lines.size();
    return scene;
}

}  // namespace lumi::tools
