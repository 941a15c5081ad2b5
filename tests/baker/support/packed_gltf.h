// SPDX-License-Identifier: MIT
// Writes a glTF square as compressors do.
#pragma once

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include "support/gltf_bytes.h"

namespace lumi::baker::testing
{

inline std::string draco_square()
{
    const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2);
    const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    builder.SetAttributeValuesForFace(positions, draco::FaceIndex(0), corners[0], corners[1], corners[2]);
    builder.SetAttributeValuesForFace(positions, draco::FaceIndex(1), corners[0], corners[2], corners[3]);
    const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
    draco::Encoder encoder;
    draco::EncoderBuffer buffer;
    encoder.EncodeMeshToBuffer(*mesh, &buffer);
    return {buffer.data(), buffer.size()};
}

// So many primitives have the same packed bytes.
inline GltfMaker draco_gltf(const std::string& packed, size_t primitives = 1)
{
    GltfMaker maker;
    const std::string view = std::to_string(maker.view(packed));
    maker.accessor("\"componentType\":5126,\"type\":\"VEC3\",\"count\":4");
    maker.accessor("\"componentType\":5123,\"type\":\"SCALAR\",\"count\":6");
    maker.add(
        "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"extensionsRequired\":[\"KHR_draco_mesh_"
        "compression\"]");
    std::string list;
    for (size_t k = 0; k < primitives; ++k) {
        list += (k == 0 ? "" : ",") +
                ("{\"attributes\":{\"POSITION\":0},\"indices\":1,\"extensions\":{\"KHR_draco_mesh_compression\":{"
                 "\"bufferView\":" +
                 view + ",\"attributes\":{\"POSITION\":0}}}}");
    }
    maker.add("\"meshes\":[{\"primitives\":[" + list + "]}]");
    return maker;
}

// The text of a file whose views lie in a buffer without bytes; they are packed in the binary chunk.
inline std::string meshopt_glb(const std::string& vertices, const std::string& indices, size_t vertex_count = 4)
{
    const auto view = [](size_t length, size_t offset, size_t packed, size_t stride, size_t count, const char* mode) {
        return "{\"buffer\":1,\"byteLength\":" + std::to_string(length) +
               ",\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0,\"byteOffset\":" + std::to_string(offset) +
               ",\"byteLength\":" + std::to_string(packed) + ",\"byteStride\":" + std::to_string(stride) +
               ",\"count\":" + std::to_string(count) + ",\"mode\":\"" + mode + "\"}}}";
    };
    GltfMaker parts;
    parts.view(vertices + indices);
    std::string text =
        "{\"asset\":{\"version\":\"2.0\"},\"extensionsRequired\":[\"EXT_meshopt_compression\"],\"buffers\":[{"
        "\"byteLength\":" +
        std::to_string(parts.bin().size()) +
        "},{\"byteLength\":1000,\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":true}}}],\"bufferViews\":[" +
        view(48, 0, vertices.size(), 12, vertex_count, "ATTRIBUTES") + "," +
        view(12, vertices.size(), indices.size(), 2, 6, "TRIANGLES") +
        "],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":4},"
        "{\"bufferView\":1,\"componentType\":5123,\"type\":\"SCALAR\",\"count\":6}],"
        "\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}]}";
    return GltfMaker::glb_of(text, parts.bin());
}

inline std::string meshopt_square(size_t vertex_count = 4)
{
    const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const unsigned int list[6] = {0, 1, 2, 0, 2, 3};
    std::string vertices(meshopt_encodeVertexBufferBound(4, 12), '\0'),
        indices(meshopt_encodeIndexBufferBound(6, 4), '\0');
    vertices.resize(
        meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(vertices.data()), vertices.size(), corners, 4, 12));
    indices.resize(
        meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(indices.data()), indices.size(), list, 6));
    return meshopt_glb(vertices, indices, vertex_count);
}

}  // namespace lumi::baker::testing
