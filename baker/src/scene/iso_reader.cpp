// SPDX-License-Identifier: MIT
#include "scene/iso_reader.h"

#include "util/text_lines.h"
#include "volume/iso_surface.h"
#include "volume/volume_file.h"

namespace lumi::baker
{
namespace
{

Material bone()
{
    Material material;
    material.name = "iso";
    material.base = {0.72f, 0.66f, 0.54f};
    material.specular = true;
    material.alpha = alpha_from_roughness(0.35f);
    material.finish();
    return material;
}

}  // namespace

SceneParts read_iso_surface(const std::filesystem::path& file, const IsoSurface& surface)
{
    const Grid grid = read_grid(file);
    SceneParts parts;
    parts.mesh = iso_surface(grid, surface.value);
    if (parts.mesh.corners.empty()) {
        throw SceneError(at({file.string()}, "no surface has the value " + number_text(surface.value) +
                                                 ": those of the volume reach from " + range_of(grid) +
                                                 "; choose one between them"));
    }
    keep_large_pieces(parts.mesh, surface.pieces);
    add_smooth_normals(parts.mesh);
    parts.materials = {bone()};
    parts.up = UpAxis::z;
    return parts;
}

std::string range_of_volume(const std::filesystem::path& file)
{
    return range_of(read_grid(file));
}

}  // namespace lumi::baker
