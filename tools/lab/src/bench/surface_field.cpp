// SPDX-License-Identifier: MIT
#include "bench/surface_field.h"

#include "files/field_report.h"
#include "files/sha256.h"
#include "lumi/baker/scene.h"
#include "lumi/baker/surface.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"

namespace lumi::bench
{

baker::SurfaceSettings surface_settings()
{
    baker::SurfaceSettings settings;
    settings.triangles = 2777;
    settings.longest_edge = 0.28f;
    settings.texels_per_radius = 82.4f;
    settings.paths_per_texel = 20;
    return settings;
}

namespace
{

void bake(const std::filesystem::path& scene_file, const std::filesystem::path& path)
{
    std::vector<std::string> warnings;
    const baker::Scene scene = baker::load_scene(scene_file, {}, warnings);
    tools::ProgressPrinter printer(stderr, tools::stderr_is_terminal());
    try {
        baker::bake_surface(scene, surface_settings(), path, tools::watch(printer));
    } catch (const baker::Cancelled&) {
        throw tools::Interrupted();
    }
}

}  // namespace

tools::FieldFile require_surface_field(const Settings& settings)
{
    std::filesystem::path path = settings.surface_file;
    if (path.empty()) {
        path = settings.work / (settings.field.scene.stem().string() + ".surface.lumi");
        if (!std::filesystem::exists(path)) bake(settings.field.scene, path);
    }
    tools::FieldFile file(path.string());
    if (!file.is_surface()) throw tools::Failure(path, "holds a chord field", "give a surface field");
    return file;
}

SurfaceFacts facts_of(const tools::FieldFile& file)
{
    const SurfaceField& field = file.surface();
    return {std::filesystem::path(file.path()).filename().string(),
            static_cast<uint32_t>(file.size()),
            field.vertex_count,
            field.patch_count,
            tools::triangles_of(field),
            tools::sha256(file.bytes(), file.size())};
}

}  // namespace lumi::bench
