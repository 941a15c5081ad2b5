// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/stepping/lattice_line.h"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "lattice/polar.h"
#include "report.h"

using namespace lumi::detail;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr int32_t kStepQ12 = 2800;
#else
constexpr int32_t kStepQ12 = 311;
#endif

constexpr int32_t kWholeQ16 = 1 << 16;
constexpr int32_t kReachQ12 = 6 << 12;   // beyond the outermost corners of the table, at sqrt(44.5)
constexpr int32_t kInsideQ12 = 4 << 12;  // within the triangles, whatever the azimuth

PolarLine line_at(int32_t x_q12, int32_t y_q12, int32_t triangle)
{
    PolarLine line{};
    line.x_q12 = x_q12, line.y_q12 = y_q12;
    line.triangle = triangle;
    line.find(0);
    return line;
}

// How far the place that corners and weights mean lies from the line's own.
int32_t error_q12(const PolarLine& line)
{
    int64_t x = 0, y = 0;
    for (int k = 0; k < 3; ++k) {
        const polar::PlanePoint p = polar::plane_point(static_cast<uint32_t>(line.corner[k]));
        x += int64_t{line.weight_q16[k]} * p.x_q12;
        y += int64_t{line.weight_q16[k]} * p.y_q12;
    }
    const auto distance = [](int64_t sum, int32_t place) { return std::abs(static_cast<int32_t>(sum >> 16) - place); };
    const int32_t dx = distance(x, line.x_q12), dy = distance(y, line.y_q12);
    return dx > dy ? dx : dy;
}

}  // namespace

TEST_CASE("a search from any polar triangle ends at the place, and beyond the table in one of its triangles")
{
    constexpr int32_t kRoundingQ12 = 2;  // places are whole numbers, and weights are rounded
    lumi::Worst worst;
    for (int32_t y = -kReachQ12; y <= kReachQ12; y += kStepQ12) {
        for (int32_t x = -kReachQ12; x <= kReachQ12; x += kStepQ12) {
            for (int32_t begin = 0; begin < polar::kWalkTriangles; ++begin) {
                const PolarLine line = line_at(x, y, begin);
                INFO("(" << x << ", " << y << ") in Q12, from triangle " << begin);
                REQUIRE((line.triangle >= 0 && line.triangle < polar::kWalkTriangles));
                const int32_t* const w = line.weight_q16;
                REQUIRE((w[0] >= 0 && w[1] >= 0 && w[2] >= 0 && w[0] + w[1] + w[2] == kWholeQ16));
                if (int64_t{x} * x + int64_t{y} * y > int64_t{kInsideQ12} * kInsideQ12) continue;
                const int32_t error = error_q12(line);
                worst.see(error, static_cast<uint64_t>(begin));
                REQUIRE(error <= kRoundingQ12);
            }
        }
    }
    worst.report("places of polar triangles in Q12, by the triangle where the search began");
}
