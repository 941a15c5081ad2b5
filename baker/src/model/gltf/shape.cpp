// SPDX-License-Identifier: MIT
#include "model/gltf/shape.h"

#include <numeric>

#include "model/gltf/accessor.h"

namespace lumi::baker
{
namespace
{

enum Mode : int32_t { kTriangles = 4, kStrip, kFan };

template <class T>
T element_at(const std::vector<float>& numbers, size_t first);
template <>
Vec2 element_at(const std::vector<float>& numbers, size_t first)
{
    return {numbers[first], numbers[first + 1]};
}
template <>
Vec3 element_at(const std::vector<float>& numbers, size_t first)
{
    return {numbers[first], numbers[first + 1], numbers[first + 2]};
}
template <>
Rgb element_at(const std::vector<float>& numbers, size_t first)
{
    return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

// Empty where the primitive has none, or too few for its vertices.
template <class T>
std::vector<T> elements_of(const GltfModel& model, const GltfPrimitive& primitive, const std::string& name)
{
    constexpr size_t kWidth = sizeof(T) / sizeof(float);
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) return {};
    const std::vector<float> numbers = floats_of(model, found->second, kWidth);
    std::vector<T> result;
    result.reserve(numbers.size() / kWidth);
    for (size_t k = 0; k < numbers.size(); k += kWidth) result.push_back(element_at<T>(numbers, k));
    return result;
}

std::vector<Vec2> uvs_of(const GltfModel& model, const GltfPrimitive& primitive, int32_t set)
{
    return elements_of<Vec2>(model, primitive, "TEXCOORD_" + std::to_string(set));
}

template <class T>
void drop_if_short(std::vector<T>& list, size_t vertices, Losses& losses)
{
    if (list.empty() || list.size() >= vertices) return;
    losses.add("attribute(s) have fewer entries than there are vertices and are left out; export the file again");
    list.clear();
}

std::vector<uint32_t> corners_of(const GltfModel& model, const GltfPrimitive& primitive, size_t vertices)
{
    std::vector<uint32_t> corners;
    if (primitive.indices != kNoIndex) {
        corners = indices_of(model, primitive.indices);
    } else {
        corners.resize(vertices);
        std::iota(corners.begin(), corners.end(), 0u);
    }
    for (const uint32_t corner : corners) {
        if (corner >= vertices) {
            fail_gltf(model, "a triangle uses vertex " + std::to_string(corner) + ", but there are " +
                                 std::to_string(vertices) + "; the file is damaged, export it again");
        }
    }
    return corners;
}

std::array<uint32_t, 3> triangle_of(const std::vector<uint32_t>& corners, size_t k, int32_t mode)
{
    if (mode == kTriangles) return {corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]};
    if (mode == kFan) return {corners[0], corners[k + 1], corners[k + 2]};
    return k % 2 == 0 ? std::array<uint32_t, 3>{corners[k], corners[k + 1], corners[k + 2]}
                      : std::array<uint32_t, 3>{corners[k + 1], corners[k], corners[k + 2]};
}

}  // namespace

GltfShape shape_of(const GltfModel& model, const GltfPrimitive& primitive, const std::vector<int32_t>& uv_sets,
                   Losses& losses)
{
    GltfShape shape;
    if (primitive.compressed && primitive.attributes.empty())
        fail_gltf(model, "its meshes are compressed by Draco; export it without compression");
    if (primitive.mode < kTriangles || primitive.mode > kFan) {
        losses.add("primitive(s) are points or lines, which are not drawn; give them a thickness, as meshes");
        return shape;
    }
    shape.positions = elements_of<Vec3>(model, primitive, "POSITION");
    if (shape.positions.empty()) {
        losses.add("primitive(s) have no positions and are left out; export the file again");
        return shape;
    }
    const size_t vertices = shape.positions.size();
    shape.normals = elements_of<Vec3>(model, primitive, "NORMAL");
    shape.uvs = uvs_of(model, primitive, uv_sets.empty() ? 0 : uv_sets[0]);
    if (uv_sets.size() > 1) shape.second_uvs = uvs_of(model, primitive, uv_sets[1]);
    shape.colours = elements_of<Rgb>(model, primitive, "COLOR_0");
    drop_if_short(shape.normals, vertices, losses);
    drop_if_short(shape.uvs, vertices, losses);
    drop_if_short(shape.second_uvs, vertices, losses);
    if (shape.uvs.empty() && !shape.second_uvs.empty()) shape.uvs.resize(shape.second_uvs.size());
    drop_if_short(shape.colours, vertices, losses);
    const std::vector<uint32_t> corners = corners_of(model, primitive, vertices);
    const size_t count = primitive.mode == kTriangles ? corners.size() / 3
                         : corners.size() < 3         ? 0
                                                      : corners.size() - 2;
    if (primitive.mode == kTriangles && corners.size() % 3 != 0)
        losses.add("primitive(s) end in the middle of a triangle, which is left out; export the file again");
    for (size_t k = 0; k < count; ++k) shape.triangles.push_back(triangle_of(corners, k, primitive.mode));
    return shape;
}

}  // namespace lumi::baker
