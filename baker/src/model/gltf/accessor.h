// SPDX-License-Identifier: MIT
// Reads the numbers of a glTF file's accessors: of any component type, quantised, with gaps, or sparse.
#pragma once

#include "model/gltf/model.h"

namespace lumi::baker
{

// How many elements it has. Throws SceneError where the accessor is not there or reaches beyond its buffer.
size_t count_of(const GltfModel& model, int32_t accessor);

// The elements in `rows`, which ascend and are below count_of(), of `width` numbers each, one after the other. Whole
// numbers of normalised accessors become 0 to 1 or -1 to 1. Numbers beyond the accessor's own width are 1, as an alpha
// that is not given. Takes as long as there are rows and sparse replacements, however many elements there are. Throws
// SceneError, also where a row holds what is not finite.
std::vector<float> floats_of(const GltfModel& model, int32_t accessor, size_t width, const std::vector<uint32_t>& rows);

// All elements, one whole number each. Throws SceneError.
std::vector<uint32_t> indices_of(const GltfModel& model, int32_t accessor);

}  // namespace lumi::baker
