// SPDX-License-Identifier: MIT
#include "scene/doubts.h"
#include "scene/framing.h"
#include "scene/iso_reader.h"
#include "scene/model_reader.h"
#include "scene/scene_data.h"
#include "scene/scene_file.h"
#include "util/text_lines.h"
#include "volume/volume_file.h"

namespace lumi::baker
{
namespace
{

SceneParts read_volume_file(const std::filesystem::path& file, const std::optional<IsoSurface>& iso)
{
    if (!iso) {
        throw SceneError(at({file.string()},
                            "a volume becomes a scene by the surface of one value; say which with --iso, "
                            "from " +
                                range_of_volume(file)));
    }
    return read_iso_surface(file, *iso);
}

SceneParts read_parts(const std::filesystem::path& file, const LoadOptions& options, std::vector<std::string>& warnings)
{
    if (is_volume_file(file)) return read_volume_file(file, options.iso);
    refuse_foreign_volume(file);
    if (options.iso) {
        throw SceneError(at({file.string()},
                            "this is no volume, and only volumes have iso-surfaces; leave out --iso, or "
                            "name a .nii, .nii.gz or .vdb file"));
    }
    return file.extension() == ".json" ? read_scene_file(file, options.up, warnings, options.colours)
                                       : read_model(file, warnings, options.colours);
}

}  // namespace

Scene load_scene(const std::filesystem::path& file, const LoadOptions& options, std::vector<std::string>& warnings)
{
    SceneParts parts = read_parts(file, options, warnings);
    if (!options.frame.empty()) frame_part(file, options.frame, parts);
    const std::array<double, 3> origin = parts.origin;
    Scene scene = build_scene(std::move(parts), options);
    for (const std::string& warning : scene.data().choice.warnings) warnings.push_back(at({file.string()}, warning));
    report_doubts(scene.data(), origin, file, warnings);
    return scene;
}

}  // namespace lumi::baker
