// SPDX-License-Identifier: MIT
#include "scene/iso_fields.h"

#include "scene/iso_reader.h"
#include "scene/material_fields.h"
#include "scene/materials.h"
#include "scene/number_ranges.h"

namespace lumi::baker
{

SceneParts read_iso_object(const std::filesystem::path& scene_file, JsonFields& fields)
{
    const JsonValue& volume = fields.require("volume");
    const std::filesystem::path path = find_beside(scene_file, fields.text_of(volume, "volume"));
    if (path.empty()) {
        fields.fail(volume,
                    "the volume '" + volume.text + "' is missing; put it beside " + scene_file.filename().string());
    }
    IsoSurface surface;
    surface.value = static_cast<float>(fields.number_of(fields.require("iso"), "iso", kScalar));
    fields.number("pieces", kShare, surface.pieces);
    SceneParts parts = read_iso_surface(path, surface);
    if (const JsonValue* changes = fields.find("material"))
        apply_material_fields(scene_file.string(), *changes, parts.materials[0]);
    return parts;
}

}  // namespace lumi::baker
