// SPDX-License-Identifier: MIT
// Writes small glTF files: numbers go into one buffer, all else is JSON that a test states.
#pragma once

#include <cstring>
#include <string>
#include <vector>

namespace lumi::baker::testing
{

class GltfMaker
{
public:
    // A view of some bytes; gives its number.
    size_t view(const std::string& bytes, const std::string& more = "")
    {
        views_ += std::string(views_.empty() ? "" : ",") +
                  "{\"buffer\":0,\"byteOffset\":" + std::to_string(bin_.size()) +
                  ",\"byteLength\":" + std::to_string(bytes.size()) + more + "}";
        bin_ += bytes;
        bin_.resize((bin_.size() + 3) / 4 * 4);
        return views_count_++;
    }

    // An accessor of a view of its own; gives its number. `more` goes on after its last member.
    template <class T>
    size_t numbers(const std::vector<T>& numbers, int component, const std::string& type, size_t count,
                   const std::string& more = "")
    {
        std::string bytes(numbers.size() * sizeof(T), '\0');
        std::memcpy(bytes.data(), numbers.data(), bytes.size());
        return accessor("\"bufferView\":" + std::to_string(view(bytes)) +
                        ",\"componentType\":" + std::to_string(component) + ",\"type\":\"" + type +
                        "\",\"count\":" + std::to_string(count) + more);
    }
    size_t vec3(const std::vector<float>& list) { return numbers(list, 5126, "VEC3", list.size() / 3); }
    size_t vec2(const std::vector<float>& list) { return numbers(list, 5126, "VEC2", list.size() / 2); }
    size_t indices(const std::vector<uint16_t>& list) { return numbers(list, 5123, "SCALAR", list.size()); }

    size_t accessor(const std::string& members)
    {
        accessors_ += std::string(accessors_.empty() ? "" : ",") + "{" + members + "}";
        return accessors_count_++;
    }

    // Members of the root, such as "\"nodes\":[]".
    void add(const std::string& members) { more_ += "," + members; }

    std::string json(const std::string& uri = "") const
    {
        std::string text = "{\"asset\":{\"version\":\"2.0\"}";
        if (!bin_.empty()) {
            text += ",\"buffers\":[{\"byteLength\":" + std::to_string(bin_.size()) +
                    (uri.empty() ? "" : ",\"uri\":\"" + uri + "\"") + "}]";
        }
        if (!views_.empty()) text += ",\"bufferViews\":[" + views_ + "]";
        if (!accessors_.empty()) text += ",\"accessors\":[" + accessors_ + "]";
        return text + more_ + "}";
    }

    const std::string& bin() const { return bin_; }

    std::string glb() const { return glb_of(json(), bin_); }

    static std::string glb_of(std::string text, const std::string& bin)
    {
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string chunks = word(text.size()) + "JSON" + text;
        if (!bin.empty()) chunks += word(bin.size()) + std::string("BIN\0", 4) + bin;
        constexpr size_t kHeaderBytes = 12;
        return "glTF" + word(2) + word(kHeaderBytes + chunks.size()) + chunks;
    }

private:
    static std::string word(size_t value)
    {
        std::string bytes;
        for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xFF);
        return bytes;
    }

    std::string bin_, views_, accessors_, more_;
    size_t views_count_ = 0, accessors_count_ = 0;
};

// A square of two triangles in the plane z = 0, from (0, 0) to (1, 1), with u to the right and glTF's v upside down, in
// a node that `node` adds to, of a material that `material` states. `more_nodes` follow, each after a comma.
inline GltfMaker square(const std::string& material = "", const std::string& node = "",
                        const std::string& more_nodes = "")
{
    GltfMaker maker;
    const std::string positions = std::to_string(maker.vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
    const std::string uvs = std::to_string(maker.vec2({0, 1, 1, 1, 1, 0, 0, 0}));
    const std::string indices = std::to_string(maker.indices({0, 1, 2, 0, 2, 3}));
    maker.add("\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0" + (node.empty() ? "" : "," + node) + "}" +
              more_nodes + "]");
    maker.add("\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + positions + ",\"TEXCOORD_0\":" + uvs +
              "},\"indices\":" + indices + (material.empty() ? "" : ",\"material\":0") + "}]}]");
    if (!material.empty()) maker.add("\"materials\":[{" + material + "}]");
    return maker;
}

}  // namespace lumi::baker::testing
