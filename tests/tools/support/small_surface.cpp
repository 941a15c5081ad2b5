// SPDX-License-Identifier: MIT
#include "support/small_surface.h"

#include "support/temporary_folder.h"

namespace lumi::tools::test
{

namespace
{

constexpr char kMesh[] =
    "mtllib cube.mtl\n"
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "usemtl red\nf 1 4 3 2\nf 5 6 7 8\nusemtl green\nf 1 2 6 5\nf 4 8 7 3\nusemtl blue\nf 1 5 8 4\nf 2 3 7 6\n";
constexpr char kMaterials[] =
    "newmtl red\nKd 0.8 0.2 0.1\nnewmtl green\nKd 0.2 0.7 0.2\nnewmtl blue\nKd 0.1 0.2 0.8\nPm 1\nPr 0.3\n";

baker::Scene cube_in(const baker::Environment& environment)
{
    const TemporaryFolder folder;
    std::vector<std::string> warnings;
    baker::LoadOptions options;
    options.environment = environment;
    return baker::load_scene(write_cube(folder.path()), options, warnings);
}

baker::SurfaceSettings small_settings()
{
    baker::SurfaceSettings settings;
    settings.triangles = 60;
    settings.longest_edge = 0.8f;
    settings.texels_per_radius = 8;
    settings.paths_per_texel = 20;
    return settings;
}

}  // namespace

std::string write_cube(const std::string& folder)
{
    write_content(folder + "/cube.obj", kMesh);
    write_content(folder + "/cube.mtl", kMaterials);
    return folder + "/cube.obj";
}

std::vector<std::string> small_surface_options()
{
    return {"--layout", "surface", "--triangles", "60",       "--longest-edge", "0.8",   "--texel-density",
            "8",        "--paths", "20",          "--screen", "16x16",          "--sky", "gradient"};
}

const baker::Scene& cube_scene()
{
    static const baker::Scene scene = cube_in(baker::gradient_environment());
    return scene;
}

const baker::SurfaceBake& small_surface()
{
    static const baker::SurfaceBake bake = baker::surface_field(cube_scene(), {small_settings()});
    return bake;
}

std::string small_surface_bytes()
{
    const std::vector<uint8_t>& file = small_surface().file;
    return {file.begin(), file.end()};
}

std::string glossy_surface_bytes()
{
    const std::vector<uint8_t> file =
        baker::surface_field(cube_in(baker::studio_environment()), {small_settings()}).file;
    return {file.begin(), file.end()};
}

}  // namespace lumi::tools::test
