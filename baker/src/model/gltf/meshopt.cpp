// SPDX-License-Identifier: MIT
#include <meshoptimizer.h>

#include "model/gltf/decompress.h"

namespace lumi::baker
{
namespace
{

[[noreturn]] void fail(const GltfModel& model, const char* what)
{
    fail_gltf(model, std::string("a buffer view that meshopt compressed ") + what + "; export the file again");
}

bool decode(const GltfMeshopt& packed, std::string_view from, std::string& to)
{
    const auto* bytes = reinterpret_cast<const unsigned char*>(from.data());
    if (packed.mode == "ATTRIBUTES")
        return packed.stride % 4 == 0 && packed.stride <= 256 &&
               meshopt_decodeVertexBuffer(to.data(), packed.count, packed.stride, bytes, from.size()) == 0;
    if (packed.stride != 2 && packed.stride != 4) return false;
    if (packed.mode == "TRIANGLES")
        return packed.count % 3 == 0 &&
               meshopt_decodeIndexBuffer(to.data(), packed.count, packed.stride, bytes, from.size()) == 0;
    return packed.mode == "INDICES" &&
           meshopt_decodeIndexSequence(to.data(), packed.count, packed.stride, bytes, from.size()) == 0;
}

// The stride that a filter takes is stated by the extension; others are undefined.
bool filter(const GltfMeshopt& packed, std::string& bytes)
{
    const size_t stride = packed.stride;
    if (packed.filter.empty() || packed.filter == "NONE") return true;
    if (packed.filter == "OCTAHEDRAL" && (stride == 4 || stride == 8))
        meshopt_decodeFilterOct(bytes.data(), packed.count, stride);
    else if (packed.filter == "QUATERNION" && stride == 8)
        meshopt_decodeFilterQuat(bytes.data(), packed.count, stride);
    else if (packed.filter == "EXPONENTIAL" && stride % 4 == 0)
        meshopt_decodeFilterExp(bytes.data(), packed.count, stride);
    else
        return false;
    return true;
}

}  // namespace

void unpack_meshopt(GltfModel& model, PackedBytes& bytes)
{
    std::vector<std::pair<GltfView*, std::string_view>> all;  // all claims are checked before anything is unpacked
    model.buffers.reserve(model.buffers.size() + model.views.size());  // so that the packed bytes stay where they are
    for (GltfView& view : model.views) {
        if (!view.packed) continue;
        const GltfMeshopt& packed = *view.packed;
        const std::string_view from = bytes.take(packed.buffer, packed.offset, packed.length);
        if (packed.stride == 0 || packed.count > kMostUnpacked * (from.size() + packed.stride) / packed.stride)
            fail(model, "claims more than its bytes can hold");
        bytes.claim(uint64_t{packed.count} * packed.stride);
        all.emplace_back(&view, from);
    }
    for (const auto& [to_view, from] : all) {
        GltfView& view = *to_view;
        const GltfMeshopt& packed = *view.packed;
        std::string to(packed.count * packed.stride, '\0');
        if (!decode(packed, from, to) || !filter(packed, to)) fail(model, "is damaged");
        view.buffer = static_cast<int32_t>(model.buffers.size());
        view.offset = 0;
        view.length = to.size();
        model.buffers.push_back(std::move(to));
    }
}

}  // namespace lumi::baker
