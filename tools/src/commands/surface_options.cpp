// SPDX-License-Identifier: MIT
#include "commands/surface_options.h"

#include <cstdio>

#include "lumi/surface_format.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

constexpr const char* kSurfaceOnly[] = {"--triangles", "--longest-edge", "--texel-density", "--paths"};

}  // namespace

void add_surface_options(CLI::App& command, baker::SurfaceSettings& s)
{
    command.add_option("--triangles", s.triangles, "surface: triangles of the mesh, before long edges are split")
        ->type_name("T")
        ->check(CLI::Range(uint32_t{1}, 2 * format::kMaxPatches))
        ->capture_default_str();
    command.add_option("--longest-edge", s.longest_edge, "surface: longer edges of the mesh are split, in radii")
        ->type_name("R")
        ->check(CLI::Range(0.02f, 2.0f))
        ->capture_default_str();
    command.add_option("--texel-density", s.texels_per_radius, "surface: texels along a line of one radius")
        ->type_name("D")
        ->check(CLI::Range(1.0f, 4096.0f))
        ->capture_default_str();
    command.add_option("--paths", s.paths_per_texel, "surface: light paths a texel; more cost time, never bytes")
        ->type_name("P")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
}

void refuse_surface_options(const CLI::App& command, const std::string& layout)
{
    for (const char* name : kSurfaceOnly)
        if (command.count(name) != 0) throw UsageError(std::string(name) + " does not go with --layout " + layout);
}

std::string surface_text(const baker::SurfaceBake& bake)
{
    char text[256];
    std::snprintf(text, sizeof text,
                  "surface: %u triangles%s, %u texels, %u of %u vertices with view tables; of the rays that meet the "
                  "scene it misses %.1f %%, displaces %.1f %%, adds %.1f %%\n",
                  bake.triangles, bake.two_sided ? ", seen from both sides" : "", bake.texels, bake.viewed_vertices,
                  bake.vertices, 100 * bake.loss.missed, 100 * bake.loss.displaced, 100 * bake.loss.added);
    return text;
}

}  // namespace lumi::tools
