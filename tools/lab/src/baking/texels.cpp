// SPDX-License-Identifier: MIT
#include "baking/texels.h"

#include <cstdio>

namespace lumi::baker::bench
{

Scene load(const char* file)
{
    std::vector<std::string> warnings;
    Scene scene = load_scene(file, {}, warnings);
    for (const std::string& warning : warnings) std::fprintf(stderr, "lumi-lab: warning: %s\n", warning.c_str());
    return scene;
}

}  // namespace lumi::baker::bench
