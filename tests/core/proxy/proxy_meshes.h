// SPDX-License-Identifier: MIT
// Proxy meshes for tests and measurements.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "guided/guided_bytes.h"
#include "lumi/guided/guided_field.h"

namespace lumi::test
{

inline uint32_t coordinate(double v)
{
    return static_cast<uint32_t>(std::clamp(std::lround(v * 2048 + 2048), 0l, 4095l));
}
inline Triple vertex_at(double x, double y, double z)
{
    return {coordinate(x), coordinate(y), coordinate(z)};
}

// A ball whose surface waves by `waves` of its radius: 2·around·(along - 1) triangles.
inline TestMesh ball(uint32_t around, uint32_t along, double radius, double waves = 0)
{
    const double pi = std::acos(-1.0);
    TestMesh mesh;
    const auto add = [&](double azimuth, double polar) {
        const double r = radius * (1 + waves * std::sin(5 * azimuth) * std::sin(4 * polar));
        mesh.vertices.push_back(vertex_at(r * std::sin(polar) * std::cos(azimuth),
                                          r * std::sin(polar) * std::sin(azimuth), r * std::cos(polar)));
    };
    add(0, 0);
    for (uint32_t j = 1; j < along; ++j) {
        for (uint32_t i = 0; i < around; ++i) add(2 * pi * i / around, pi * j / along);
    }
    add(0, pi);
    const auto at = [&](uint32_t i, uint32_t j) {
        return j == 0 ? 0 : j == along ? (along - 1) * around + 1 : 1 + (j - 1) * around + i % around;
    };
    for (uint32_t j = 0; j < along; ++j) {
        for (uint32_t i = 0; i < around; ++i) {
            if (j != along - 1) mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
            if (j != 0) mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
        }
    }
    return mesh;
}

// A square plate through the centre, seen from both sides.
inline TestMesh plate(double half_side)
{
    TestMesh mesh;
    mesh.vertices = {vertex_at(-half_side, -half_side, 0), vertex_at(half_side, -half_side, 0),
                     vertex_at(half_side, half_side, 0), vertex_at(-half_side, half_side, 0)};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.flags = format::kTwoSided;
    return mesh;
}

// A thin four-sided needle along an axis askew.
inline TestMesh needle()
{
    TestMesh mesh;
    mesh.vertices = {vertex_at(0.5, 0.6, 0.55), vertex_at(-0.505, -0.5, -0.6), vertex_at(-0.5, -0.505, -0.6),
                     vertex_at(-0.495, -0.5, -0.61), vertex_at(-0.5, -0.495, -0.59)};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 3, 2}, {1, 4, 3}};
    mesh.flags = format::kTwoSided;
    return mesh;
}

inline uint32_t random_below(std::mt19937& random, uint32_t end)
{
    return static_cast<uint32_t>(random() % end);
}

// Triangles of any size anywhere in the cube, which the file can hold although the sphere cuts its corners off.
inline TestMesh soup(std::mt19937& random, uint32_t triangles)
{
    TestMesh mesh;
    for (uint32_t k = 0; k < 3 * triangles; ++k) {
        const bool anywhere = k % 3 == 0 || k % 6 < 3;
        const Triple base = anywhere ? Triple{} : mesh.vertices[k - k % 3];
        const auto number = [&](uint32_t from) {
            return std::min<uint32_t>(4095, from + random_below(random, anywhere ? 4096 : 200));
        };
        mesh.vertices.push_back({number(base[0]), number(base[1]), number(base[2])});
        if (k % 3 == 2) mesh.triangles.push_back({k - 2, k - 1, k});
    }
    mesh.flags = random_below(random, 2) == 0 ? format::kTwoSided : 0;
    return mesh;
}

// A mesh in the file's packed form.
struct PackedMesh {
    explicit PackedMesh(const TestMesh& mesh)
    {
        put_triples(vertices, mesh.vertices);
        put_triples(triangles, mesh.triangles);
        view = {vertices.data(), triangles.data(), static_cast<uint32_t>(mesh.vertices.size()),
                static_cast<uint32_t>(mesh.triangles.size()), (mesh.flags & format::kTwoSided) != 0};
    }
    PackedMesh(const PackedMesh&) = delete;
    PackedMesh& operator=(const PackedMesh&) = delete;

    Bytes vertices, triangles;
    ProxyMesh view;
};

}  // namespace lumi::test
