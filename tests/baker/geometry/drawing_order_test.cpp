// SPDX-License-Identifier: MIT
#include "geometry/drawing_order.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

namespace lumi::baker::testing
{
namespace
{

// Triangles as faces of their own.
struct TestFaces {
    Mesh mesh;
    std::vector<uint32_t> numbers;

    // Both sides of a triangle.
    void add(const Vec3& a, const Vec3& b, const Vec3& c)
    {
        const auto first = static_cast<uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), {a, b, c});
        for (const Mesh::Corners& corners :
             {Mesh::Corners{first, first + 1, first + 2}, {first, first + 2, first + 1}}) {
            numbers.push_back(static_cast<uint32_t>(mesh.corners.size()));
            mesh.corners.push_back(corners);
        }
    }
    void add_quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
    {
        add(a, b, c);
        add(a, c, d);
    }
    OneSidedFaces all() const { return {mesh, numbers}; }
};

// A closed box with large triangles.
TestFaces plate(float half, float height)
{
    TestFaces faces;
    const auto at = [&](float x, float y, float z) { return Vec3{x * half, y * half, z * height}; };
    faces.add_quad(at(-1, -1, 1), at(1, -1, 1), at(1, 1, 1), at(-1, 1, 1));
    faces.add_quad(at(1, -1, 0), at(-1, -1, 0), at(-1, 1, 0), at(1, 1, 0));
    for (const float s : {-1.0f, 1.0f}) {
        faces.add_quad(at(s, -1, 0), at(s, 1, 0), at(s, 1, 1), at(s, -1, 1));
        faces.add_quad(at(-1, s, 0), at(1, s, 0), at(1, s, 1), at(-1, s, 1));
    }
    return faces;
}

void add_tube(TestFaces& faces, float radius, float low, float high)
{
    constexpr int kSides = 12;
    const auto at = [&](int k, float z) {
        const auto angle = static_cast<float>(2 * M_PI / kSides * k);
        return Vec3{radius * std::cos(angle), radius * std::sin(angle), z};
    };
    for (int k = 0; k < kSides; ++k) faces.add_quad(at(k, low), at(k + 1, low), at(k + 1, high), at(k, high));
}

OrderFaults faults_of(const TestFaces& faces, const std::vector<uint32_t>& order)
{
    Job job(1, 1, {});
    return order_faults(faces.all(), order, job);
}

std::vector<uint32_t> order_of(const TestFaces& faces, unsigned threads = 1)
{
    Job job(1, threads, {});
    return drawing_order(faces.all(), job);
}

}  // namespace

TEST_CASE("both faces of a thin plate are in order from everywhere, which depths do not tell")
{
    const TestFaces faces = plate(0.6f, 0.02f);
    const OrderFaults faults = faults_of(faces, order_of(faces));
    CHECK(faults.in_order == 0);
    CHECK(faults.by_depth > 0.05);
}

TEST_CASE("the walls of a tube within a tube are in order from everywhere")
{
    TestFaces faces;
    add_tube(faces, 0.6f, -0.6f, 0.6f);
    add_tube(faces, 0.55f, -0.6f, 0.6f);
    const OrderFaults faults = faults_of(faces, order_of(faces));
    CHECK(faults.in_order < 0.001);
    CHECK(faults.by_depth > 0.01);
}

TEST_CASE("one turned against the order is wrong where depths are right")
{
    // Two squares that face up: the order is plain, and so is what the other one costs.
    TestFaces faces;
    faces.add({-0.5f, -0.5f, 0.4f}, {0.5f, -0.5f, 0.4f}, {0, 0.5f, 0.4f});
    faces.add({-0.5f, -0.5f, -0.4f}, {0.5f, -0.5f, -0.4f}, {0, 0.5f, -0.4f});
    std::vector<uint32_t> order = order_of(faces);
    CHECK(faults_of(faces, order).in_order == 0);
    std::reverse(order.begin(), order.end());
    CHECK(faults_of(faces, order).in_order == 1);
    CHECK(faults_of(faces, order).by_depth < 0.3);
}

TEST_CASE("an order has each face once, and is the same with any number of threads")
{
    const TestFaces faces = plate(0.5f, 0.3f);
    const std::vector<uint32_t> order = order_of(faces);
    CHECK(order == order_of(faces, 3));
    std::vector<uint32_t> sorted = order, wanted(faces.numbers.size());
    std::sort(sorted.begin(), sorted.end());
    std::iota(wanted.begin(), wanted.end(), 0u);
    CHECK(sorted == wanted);
    CHECK(order_of(TestFaces{}).empty());
}

}  // namespace lumi::baker::testing
