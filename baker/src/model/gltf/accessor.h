// SPDX-License-Identifier: MIT
// The numbers of a glTF file's accessors: of any component type, quantised, with gaps, or sparse.
#pragma once

#include "model/gltf/model.h"

namespace lumi::baker
{

// Elements of `width` numbers each, one after the other. Whole numbers of normalised accessors become 0 to 1 or -1
// to 1. Numbers beyond the accessor's own width are 1, as an alpha that is not given. Throws SceneError where the
// accessor is not there, reaches beyond its buffer, or holds what is not finite.
std::vector<float> floats_of(const GltfModel& model, int32_t accessor, size_t width);

// One whole number an element. Throws SceneError.
std::vector<uint32_t> indices_of(const GltfModel& model, int32_t accessor);

}  // namespace lumi::baker
