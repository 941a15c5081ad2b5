// SPDX-License-Identifier: MIT
#include "model/gltf/shape.h"

#include <algorithm>
#include <numeric>

#include "model/gltf/accessor.h"

namespace lumi::baker
{
namespace
{

enum Mode : int32_t { kTriangles = 4, kStrip, kFan };

// Bounds texture coordinates and colours: beyond it no pixel would be found again, and sums overflow.
float bounded(float number)
{
    constexpr float kMost = 1e6f;
    return std::clamp(number, -kMost, kMost);
}

template <class T>
T element_at(const std::vector<float>& numbers, size_t first);
template <>
Vec2 element_at(const std::vector<float>& numbers, size_t first)
{
    return {bounded(numbers[first]), bounded(numbers[first + 1])};
}
template <>
Vec3 element_at(const std::vector<float>& numbers, size_t first)
{
    return {numbers[first], numbers[first + 1], numbers[first + 2]};
}
template <>
Rgb element_at(const std::vector<float>& numbers, size_t first)
{
    return {bounded(numbers[first]), bounded(numbers[first + 1]), bounded(numbers[first + 2])};
}

// Holds of a primitive's attributes the elements of those vertices that its triangles use.
class Attributes
{
public:
    Attributes(const GltfModel& model, const GltfPrimitive& primitive, size_t vertices,
               const std::vector<uint32_t>& rows, Losses& losses)
        : model_(model), primitive_(primitive), vertices_(vertices), rows_(rows), losses_(losses)
    {
    }

    // Empty where the primitive has none, or too few for its vertices.
    template <class T>
    std::vector<T> read(const std::string& name) const
    {
        constexpr size_t kWidth = sizeof(T) / sizeof(float);
        const auto found = primitive_.attributes.find(name);
        if (found == primitive_.attributes.end() || is_short(found->second)) return {};
        const std::vector<float> numbers = floats_of(model_, found->second, kWidth, rows_);
        std::vector<T> result;
        result.reserve(rows_.size());
        for (size_t k = 0; k < numbers.size(); k += kWidth) result.push_back(element_at<T>(numbers, k));
        return result;
    }

    std::vector<Vec2> read_uvs(int32_t set) const { return read<Vec2>("TEXCOORD_" + std::to_string(set)); }

private:
    bool is_short(int32_t accessor) const
    {
        const size_t count = count_of(model_, accessor);
        if (count != 0 && count < vertices_)
            losses_.add(
                "attribute(s) have fewer entries than there are vertices and are left out; export the file again");
        return count < vertices_;
    }

    const GltfModel& model_;
    const GltfPrimitive& primitive_;
    size_t vertices_;
    const std::vector<uint32_t>& rows_;
    Losses& losses_;
};

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

GltfTriangle triangle_of(const std::vector<uint32_t>& corners, size_t k, int32_t mode)
{
    if (mode == kTriangles) return {corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]};
    if (mode == kFan) return {corners[0], corners[k + 1], corners[k + 2]};
    return k % 2 == 0 ? GltfTriangle{corners[k], corners[k + 1], corners[k + 2]}
                      : GltfTriangle{corners[k + 1], corners[k], corners[k + 2]};
}

std::vector<GltfTriangle> triangles_of(const GltfModel& model, const GltfPrimitive& primitive, size_t vertices,
                                       Losses& losses)
{
    const std::vector<uint32_t> corners = corners_of(model, primitive, vertices);
    const size_t count = primitive.mode == kTriangles ? corners.size() / 3
                         : corners.size() < 3         ? 0
                                                      : corners.size() - 2;
    if (primitive.mode == kTriangles && corners.size() % 3 != 0)
        losses.add("primitive(s) end in the middle of a triangle, which is left out; export the file again");
    std::vector<GltfTriangle> triangles;
    triangles.reserve(count);
    for (size_t k = 0; k < count; ++k) triangles.push_back(triangle_of(corners, k, primitive.mode));
    return triangles;
}

// The vertices that triangles use, in ascending order. Takes no longer where there are many more of them.
std::vector<uint32_t> used_by(const std::vector<GltfTriangle>& triangles, size_t vertices)
{
    std::vector<uint32_t> used;
    if (3 * triangles.size() < vertices) {
        for (const GltfTriangle& t : triangles) used.insert(used.end(), t.begin(), t.end());
        std::sort(used.begin(), used.end());
        used.erase(std::unique(used.begin(), used.end()), used.end());
        return used;
    }
    std::vector<bool> is_used(vertices, false);
    for (const GltfTriangle& t : triangles)
        for (const uint32_t vertex : t) is_used[vertex] = true;
    for (uint32_t k = 0; k < vertices; ++k)
        if (is_used[k]) used.push_back(k);
    return used;
}

// From vertices to their places in `used`.
void renumber(std::vector<GltfTriangle>& triangles, const std::vector<uint32_t>& used)
{
    for (GltfTriangle& t : triangles)
        for (uint32_t& vertex : t)
            vertex = static_cast<uint32_t>(std::lower_bound(used.begin(), used.end(), vertex) - used.begin());
}

}  // namespace

GltfShape shape_of(const GltfModel& model, const GltfPrimitive& primitive, const std::vector<int32_t>& uv_sets,
                   Losses& losses, std::vector<uint32_t>& used)
{
    GltfShape shape;
    if (primitive.mode < kTriangles || primitive.mode > kFan) {
        losses.add("primitive(s) are points or lines, which are not drawn; give them a thickness, as meshes");
        return shape;
    }
    const auto positions = primitive.attributes.find("POSITION");
    const size_t vertices = positions == primitive.attributes.end() ? 0 : count_of(model, positions->second);
    if (vertices == 0) {
        losses.add("primitive(s) have no positions and are left out; export the file again");
        return shape;
    }
    shape.triangles = triangles_of(model, primitive, vertices, losses);
    used = used_by(shape.triangles, vertices);
    if (used.size() < vertices) renumber(shape.triangles, used);
    const Attributes attributes(model, primitive, vertices, used, losses);
    shape.positions = attributes.read<Vec3>("POSITION");
    shape.normals = attributes.read<Vec3>("NORMAL");
    shape.uvs = attributes.read_uvs(uv_sets.empty() ? 0 : uv_sets[0]);
    if (uv_sets.size() > 1) shape.second_uvs = attributes.read_uvs(uv_sets[1]);
    shape.colours = attributes.read<Rgb>("COLOR_0");
    if (shape.uvs.empty() && !shape.second_uvs.empty()) shape.uvs.resize(shape.second_uvs.size());
    return shape;
}

size_t replacements_of(const GltfModel& model, const GltfPrimitive& primitive)
{
    std::vector<int32_t> read = {primitive.indices};
    for (const auto& [name, accessor] : primitive.attributes) read.push_back(accessor);
    for (const auto& target : primitive.targets)
        for (const auto& [name, accessor] : target) read.push_back(accessor);
    size_t sum = 0;
    for (const int32_t accessor : read) {
        if (accessor < 0 || static_cast<size_t>(accessor) >= model.accessors.size()) continue;
        const std::optional<GltfRun>& replaced = model.accessors[static_cast<size_t>(accessor)].sparse_indices;
        if (replaced) sum += std::min(replaced->count, kMostReplacements + 1);
    }
    return sum;
}

}  // namespace lumi::baker
