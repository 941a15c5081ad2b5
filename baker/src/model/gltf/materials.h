// SPDX-License-Identifier: MIT
// Turns glTF's materials into ours.
//
// clang-format off
// glTF                                  here
// base colour                           of metal as it is; of the body under a skin times 1 - F0, as glTF mixes the two
// metallic, roughness                   metalness, alpha = roughness²; pictures: blue and green
// KHR_materials_ior, _specular          the skin's index, so that it reflects F0 from straight above; the largest
//                                       component of its colour counts
// KHR_materials_transmission            that share of what is not metal is glass of the index, coloured by base colour
//                                       and _volume; without a volume, a pane where it is a sheet
// KHR_materials_pbrSpecularGlossiness   the metal and the body that have both its colours
// emissive, _emissive_strength          radiance from both sides
// KHR_materials_unlit                   radiance of the base colour
// alpha mode MASK, BLEND                opacity, cut at the cutoff; the share of light that does not pass
// KHR_materials_clearcoat, _sheen       coat and fibres; of their pictures the means
// occlusion                             nothing: it is traced
// clang-format on
#pragma once

#include "model/gltf/model.h"
#include "model/losses.h"
#include "model/scene_parts.h"

namespace lumi::baker
{

// A material, and which texture coordinates its pictures take.
struct GltfSurface {
    Material material;             // finished
    std::vector<int32_t> uv_sets;  // the file's numbers of the first and the second one; as many as pictures use
    bool tinted = false;           // glass whose base colour colours what passes once through it
    bool is_wall = false;          // glass without a volume: a pane where it is a sheet
};

// One for each material of the model, and a last one for primitives without a material. Pictures are appended to
// `textures`. Throws SceneError.
std::vector<GltfSurface> surfaces_of(const GltfModel& model, std::vector<Texture>& textures, Losses& losses,
                                     std::vector<std::string>& warnings);

}  // namespace lumi::baker
