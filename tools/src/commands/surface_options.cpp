// SPDX-License-Identifier: MIT
#include "commands/surface_options.h"

#include <cstdio>

#include "lumi/surface/format.h"
#include "program/option_checks.h"
#include "program/option_group.h"

namespace lumi::tools
{

void add_surface_options(CLI::App& command, baker::SurfaceSettings& s)
{
    const OptionGroup group(command, "Surface fields");
    command.add_option("--triangles", s.triangles, "surface: triangles of the mesh, before long edges are split")
        ->type_name("T")
        ->check(whole_number(1, 2 * detail::format::kMaxPatches))
        ->capture_default_str();
    command.add_option("--longest-edge", s.longest_edge, "surface: longer edges of the mesh are split, in radii")
        ->type_name("R")
        ->check(number(0.02, 2))
        ->capture_default_str();
    command.add_option("--texel-density", s.texels_per_radius, "surface: texels along a line of one radius")
        ->type_name("D")
        ->check(number(1, 4096))
        ->capture_default_str();
    command.add_flag_callback(
        "--no-view-tables", [&s] { s.view_tables = false; },
        "surface: colours that do not depend on the direction of view: fewer bytes, no gloss");
    command.add_option("--paths", s.paths_per_texel, "surface: light paths a texel; more cost time, never bytes")
        ->type_name("P")
        ->check(whole_number(1, kMostPaths))
        ->capture_default_str();
}

std::string surface_text(const baker::SurfaceBake& bake)
{
    char text[256];
    std::snprintf(text, sizeof text,
                  "surface: %u triangles, %u texels, %u of %u vertices with view tables; of the rays that meet the "
                  "scene it misses %.1f %%, displaces %.1f %%, adds %.1f %%\n",
                  bake.triangles, bake.texels, bake.viewed_vertices, bake.vertices, 100 * bake.loss.missed,
                  100 * bake.loss.displaced, 100 * bake.loss.added);
    return text;
}

nlohmann::json surface_json(const baker::SurfaceBake& bake)
{
    return {{"triangles", bake.triangles},     {"vertices", bake.vertices},  {"viewed_vertices", bake.viewed_vertices},
            {"texels", bake.texels},           {"missed", bake.loss.missed}, {"added", bake.loss.added},
            {"displaced", bake.loss.displaced}};
}

}  // namespace lumi::tools
