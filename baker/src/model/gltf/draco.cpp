// SPDX-License-Identifier: MIT
#include <draco/compression/decode.h>

#include <cstring>
#include <new>

#include "model/gltf/decompress.h"

namespace lumi::baker
{
namespace
{

[[noreturn]] void fail(const GltfModel& model, const char* what)
{
    fail_gltf(model, std::string("a mesh that Draco compressed ") + what + "; export the file again");
}

// Reads the bitstream's head of version 2.2 before anything is decoded: its decoder takes memory as these numbers say.
class Head
{
public:
    Head(const GltfModel& model, std::string_view bytes) : model_(model), rest_(bytes)
    {
        constexpr size_t kHeadBytes = 11;
        if (bytes.size() < kHeadBytes || bytes.substr(0, 5) != "DRACO") fail(model_, "is damaged");
        const uint8_t major = byte(5), minor = byte(6), type = byte(7), method = byte(8), flags = byte(10);
        if (major != 2 || minor != 2 || type != 1 || method > 1 || (flags & 0x80) != 0)
            fail(model_, "is no mesh of version 2.2 without metadata");
        rest_.remove_prefix(std::min(bytes.size(), kHeadBytes + method));  // a byte more says the kind of traversal
        const uint64_t first = number(), second = number();
        if (std::max(first, second) > kMostUnpacked * bytes.size()) fail(model_, "claims more than its bytes can hold");
        elements_ = first + second;
    }

    uint64_t elements() const { return elements_; }  // triangles, and vertices or points

private:
    uint8_t byte(size_t k) const { return static_cast<uint8_t>(rest_[k]); }

    uint64_t number()
    {
        uint64_t value = 0;
        for (unsigned shift = 0; shift < 35; shift += 7) {
            if (rest_.empty()) fail(model_, "is cut short");
            const uint8_t next = byte(0);
            rest_.remove_prefix(1);
            value |= static_cast<uint64_t>(next & 0x7F) << shift;
            if (next < 0x80) break;
        }
        return value;
    }

    const GltfModel& model_;
    std::string_view rest_;
    uint64_t elements_ = 0;
};

template <class T>
std::string bytes_of_list(const std::vector<T>& list)
{
    std::string bytes(list.size() * sizeof(T), '\0');
    if (!list.empty()) std::memcpy(bytes.data(), list.data(), bytes.size());
    return bytes;
}

// Whole numbers of the file's accessor that stand for 0 to 1.
float unit_of(const GltfModel& model, int32_t accessor, const draco::PointAttribute& attribute)
{
    const bool listed = accessor >= 0 && static_cast<size_t>(accessor) < model.accessors.size();
    if (!listed || !model.accessors[static_cast<size_t>(accessor)].normalized || attribute.normalized()) return 1;
    switch (attribute.data_type()) {
        case draco::DT_INT8:
            return 1.0f / 127;
        case draco::DT_UINT8:
            return 1.0f / 255;
        case draco::DT_INT16:
            return 1.0f / 32767;
        case draco::DT_UINT16:
            return 1.0f / 65535;
        default:
            return 1;
    }
}

int32_t add_attribute(GltfModel& model, const draco::Mesh& mesh, const draco::PointAttribute& attribute, float unit,
                      PackedBytes& packed)
{
    constexpr int8_t kMostComponents = 4;
    const int8_t width = static_cast<int8_t>(attribute.num_components());
    if (width < 1 || width > kMostComponents) fail(model, "has an attribute of too many numbers");
    const size_t w = static_cast<size_t>(width);
    packed.claim(uint64_t{sizeof(float)} * w * mesh.num_points());
    std::vector<float> numbers(w * mesh.num_points());
    for (uint32_t k = 0; k < mesh.num_points(); ++k) {
        const draco::AttributeValueIndex value = attribute.mapped_index(draco::PointIndex(k));
        if (value.value() >= attribute.size()) fail(model, "is damaged");
        if (!attribute.ConvertValue<float>(value, width, &numbers[w * k])) fail(model, "has numbers of a strange type");
        for (size_t c = 0; c < w; ++c) numbers[w * k + c] *= unit;
    }
    constexpr int32_t kFloat = 5126;
    return add_accessor(model, bytes_of_list(numbers), kFloat, static_cast<uint32_t>(w), mesh.num_points());
}

void unpack(GltfModel& model, GltfPrimitive& primitive, std::string_view bytes, PackedBytes& packed)
{
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size());
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) fail(model, "is damaged");
    const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
    std::vector<uint32_t> corners;
    corners.reserve(3 * size_t{mesh->num_faces()});
    for (uint32_t k = 0; k < mesh->num_faces(); ++k)
        for (const draco::PointIndex& corner : mesh->face(draco::FaceIndex(k))) corners.push_back(corner.value());
    for (const auto& [name, id] : primitive.packed->attributes) {
        const draco::PointAttribute* attribute =
            id < 0 ? nullptr : mesh->GetAttributeByUniqueId(static_cast<uint32_t>(id));
        if (!attribute) fail(model, "lacks an attribute that the file names");
        const auto known = primitive.attributes.find(name);
        const int32_t accessor = known == primitive.attributes.end() ? kNoIndex : known->second;
        primitive.attributes[name] =
            add_attribute(model, *mesh, *attribute, unit_of(model, accessor, *attribute), packed);
    }
    constexpr int32_t kUint32 = 5125, kTriangles = 4;
    const size_t count = corners.size();
    primitive.indices = add_accessor(model, bytes_of_list(corners), kUint32, 1, count);
    primitive.mode = kTriangles;
}

}  // namespace

void unpack_draco(GltfModel& model, PackedBytes& packed)
{
    constexpr uint64_t kBytesOfElement = 12;                  // three numbers
    std::vector<std::pair<GltfPrimitive*, std::string>> all;  // all claims are checked before anything is unpacked
    for (std::vector<GltfPrimitive>& mesh : model.meshes) {
        for (GltfPrimitive& primitive : mesh) {
            if (!primitive.packed) continue;
            const GltfView view = element_of(model, model.views, primitive.packed->view, "buffer view");
            all.emplace_back(&primitive, packed.take(view.buffer, view.offset, view.length));
            packed.claim(kBytesOfElement * Head(model, all.back().second).elements());
        }
    }
    for (const auto& [primitive, bytes] : all) {
        try {
            unpack(model, *primitive, bytes, packed);
        } catch (const std::bad_alloc&) {
            fail(model, "claims more memory than there is");
        }
    }
}

}  // namespace lumi::baker
