// SPDX-License-Identifier: MIT
#include "scene/model_reader.h"

#include <cmath>

#include "model/foreign_format.h"
#include "model/gltf/container.h"
#include "model/readers.h"
#include "util/text_lines.h"
#include "volume/iso_surface.h"
#include "volume/volume_file.h"

namespace lumi::baker
{

namespace
{

std::string head_of(const std::filesystem::path& file)
{
    auto stream = open_file(file);
    std::string head(kHeadBytesOfModel, '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<size_t>(stream.gcount()));
    return head;
}

}  // namespace

std::optional<AnimationTime> animation_time(const std::string& text)
{
    const size_t mark = text.rfind('@');
    AnimationTime time{text.substr(0, mark)};
    constexpr double kMostSeconds = 1e6;
    const bool sound =
        mark == std::string::npos ||
        (parse_finite(std::string_view(text).substr(mark + 1), time.seconds) && std::abs(time.seconds) <= kMostSeconds);
    return sound ? std::optional(time) : std::nullopt;
}

SceneParts read_model(const std::filesystem::path& file, std::vector<std::string>& warnings,
                      const ModelOptions& options)
{
    const std::string head = head_of(file), end = extension_of(file);
    const bool is_gltf = is_glb(head) || end == ".gltf" || end == ".glb";
    if (options.animation && !is_gltf)
        throw SceneError(at({file.string()}, "only glTF files have animations; leave out --animation"));
    if (is_glb(head)) return read_gltf(file, warnings, options.animation);
    if (is_ply(head)) return read_ply(file, warnings);
    if (is_stl(head, std::filesystem::file_size(file))) return read_stl(file, warnings);
    refuse_foreign_model(file, head);
    if (is_gltf) return read_gltf(file, warnings, options.animation);
    if (end == ".ply") return read_ply(file, warnings);
    if (end == ".stl") return read_stl(file, warnings);
    return read_obj(file, warnings, options.colours);
}

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
