// SPDX-License-Identifier: MIT
// Unpacks what EXT_meshopt_compression and KHR_draco_mesh_compression hold, so that all else reads plain buffers.
#pragma once

#include "model/gltf/model.h"

namespace lumi::baker
{

// The most bytes or triangles that a packed byte may claim: more than the formats reach on meshes that are none.
inline constexpr size_t kMostUnpacked = 64;

// Appends a buffer, its view, and an accessor of so many elements; returns the accessor's number.
int32_t add_accessor(GltfModel& model, std::string bytes, int32_t component, uint32_t width, size_t count);

// The bytes of a packed range. Throws SceneError where it is not inside its buffer, or where the file asks for its
// bytes more than twice, as `read` counts.
std::string_view packed_bytes(const GltfModel& model, int32_t buffer, size_t offset, size_t length, size_t& read);

// Throw SceneError where the packed bytes are damaged or claim too much.
void unpack_meshopt(GltfModel& model);
void unpack_draco(GltfModel& model);

}  // namespace lumi::baker
