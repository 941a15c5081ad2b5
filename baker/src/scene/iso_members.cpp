// SPDX-License-Identifier: MIT
#include "scene/iso_members.h"

#include "scene/iso_reader.h"
#include "scene/material_members.h"
#include "scene/materials.h"
#include "scene/number_ranges.h"

namespace lumi::baker
{

SceneParts read_iso_object(const std::filesystem::path& scene_file, JsonMembers& members)
{
    const JsonValue& volume = members.require("volume");
    const std::filesystem::path path = find_beside(scene_file, members.text_of(volume, "volume"));
    if (path.empty()) {
        members.fail(volume,
                     "the volume '" + volume.text + "' is missing; put it beside " + scene_file.filename().string());
    }
    IsoSurface surface;
    surface.value = static_cast<float>(members.number_of(members.require("iso"), "iso", kScalar));
    members.number("pieces", kShare, surface.pieces);
    SceneParts parts = read_iso_surface(path, surface);
    if (const JsonValue* changes = members.find("material"))
        apply_material_members(scene_file.string(), *changes, parts.materials[0]);
    return parts;
}

}  // namespace lumi::baker
