// SPDX-License-Identifier: MIT
// STL and PLY files made in memory: pyramids of four facets over the ground, the tip 1 high.
#pragma once

#include <array>
#include <cstring>
#include <string>
#include <vector>

namespace lumi::baker::testing
{

struct TestVertex {
    float x, y, z;
    std::array<uint8_t, 3> colour;
};
inline const std::vector<TestVertex> kPyramid = {{1, 1, 0, {255, 0, 0}},
                                                 {-1, 1, 0, {255, 0, 0}},
                                                 {-1, -1, 0, {255, 0, 0}},
                                                 {1, -1, 0, {255, 0, 0}},
                                                 {0, 0, 1, {255, 0, 0}}};
inline constexpr std::array<std::array<int, 3>, 4> kSides = {{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};

// The bytes of a number, the lowest one first or last.
template <class T>
std::string bytes_of_number(T value, bool big_endian = false)
{
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

inline std::string binary_stl(const std::vector<TestVertex>& vertices = kPyramid)
{
    std::string bytes(80, 's');
    bytes += bytes_of_number(uint32_t{4});
    for (const auto& side : kSides) {
        bytes.append(12, '\0');
        for (const int k : side) {
            const TestVertex& v = vertices[static_cast<size_t>(k)];
            bytes += bytes_of_number(v.x) + bytes_of_number(v.y) + bytes_of_number(v.z);
        }
        bytes.append(2, '\0');
    }
    return bytes;
}

inline std::string text_stl()
{
    std::string text = "solid pyramid\n";
    for (const auto& side : kSides) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int k : side) {
            const TestVertex& v = kPyramid[static_cast<size_t>(k)];
            text += "vertex " + std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
        }
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid pyramid\n";
}

// `index` is the type of a face's vertices, `faces` how many the heading claims.
inline std::string ply_heading(const std::string& format, const std::string& index = "int", size_t faces = 5)
{
    return "ply\nformat " + format + " 1.0\ncomment made by a test\nelement vertex 5\n" +
           "property float x\nproperty float y\nproperty float z\n" +
           "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face " + std::to_string(faces) +
           "\nproperty list uchar " + index + " vertex_indices\nend_header\n";
}

// The pyramid with its square ground.
inline std::string text_ply()
{
    std::string text = ply_heading("ascii");
    for (const TestVertex& v : kPyramid) {
        for (const float c : {v.x, v.y, v.z}) text += std::to_string(c) + " ";
        for (const uint8_t c : v.colour) text += std::to_string(c) + " ";
        text.back() = '\n';
    }
    for (const auto& side : kSides) {
        text += "3";
        for (const int k : side) text += " " + std::to_string(k);
        text += "\n";
    }
    return text + "4 3 2 1 0\n";
}

// T as `index` says.
template <class T>
std::string binary_ply(bool big_endian, const std::string& index)
{
    std::string bytes = ply_heading(big_endian ? "binary_big_endian" : "binary_little_endian", index);
    for (const TestVertex& v : kPyramid) {
        for (const float c : {v.x, v.y, v.z}) bytes += bytes_of_number(c, big_endian);
        for (const uint8_t c : v.colour) bytes += static_cast<char>(c);
    }
    for (const auto& side : kSides) {
        bytes += '\3';
        for (const int k : side) bytes += bytes_of_number(static_cast<T>(k), big_endian);
    }
    bytes += '\4';
    for (const int k : {3, 2, 1, 0}) bytes += bytes_of_number(static_cast<T>(k), big_endian);
    return bytes;
}

}  // namespace lumi::baker::testing
