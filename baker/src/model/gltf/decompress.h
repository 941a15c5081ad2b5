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

// Gives out packed bytes of a model, in all at most twice as many as its file holds: what is unpacked does not count,
// so that a file cannot ask for the same bytes again and again. What all of them unpack to has a limit as well.
class PackedBytes
{
public:
    explicit PackedBytes(const GltfModel& model);  // borrows the model, of which nothing is unpacked yet

    // Valid until a buffer is added. Throws SceneError where the range is not inside its buffer, or too much was taken.
    std::string_view take(int32_t buffer, size_t offset, size_t length);
    // Counts bytes that are about to be unpacked. Throws SceneError for too many.
    void claim(uint64_t unpacked);

private:
    const GltfModel& model_;
    size_t left_;
    uint64_t unpacked_left_;
};

// Throw SceneError where the packed bytes are damaged or claim too much.
void unpack_meshopt(GltfModel& model, PackedBytes& packed);
void unpack_draco(GltfModel& model, PackedBytes& packed);

}  // namespace lumi::baker
