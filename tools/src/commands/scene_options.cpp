// SPDX-License-Identifier: MIT
#include "scene_options.h"

#include <cstdio>

namespace lumi::tools
{

void add_scene_options(CLI::App& command, SceneOptions& options)
{
    const std::map<std::string, baker::UpAxis> axes = {{"y", baker::UpAxis::y}, {"z", baker::UpAxis::z}};
    command.add_option("SCENE", options.path, "An OBJ file; its MTL files and textures are found beside it")
        ->required();
    command.add_option("--up", options.up, "The scene's vertical axis, y or z [y]")
        ->type_name("y|z")
        ->transform(CLI::CheckedTransformer(axes));
    command.add_option("--threads", options.threads, "Threads to use [all]; the result is the same for any number")
        ->type_name("T");
}

baker::Scene load_scene(const SceneOptions& options, size_t& warnings)
{
    std::vector<std::string> lines;
    baker::LoadOptions load;
    load.up = options.up;
    baker::Scene scene = baker::load_scene(options.path, load, lines);
    for (const std::string& line : lines)
        std::fprintf(stderr, "lumi: warning: %s\n", line.c_str());
    warnings = lines.size();
    return scene;
}

}  // namespace lumi::tools
