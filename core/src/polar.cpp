// SPDX-License-Identifier: MIT
#include "polar.h"

#include "generate.h"

namespace lumi::polar
{
namespace
{

struct Pattern {
    PlanePoint point[kPoints];
};

constexpr int16_t round_q12(double v)
{
    return static_cast<int16_t>(v * 4096 + (v < 0 ? -0.5 : 0.5));
}

constexpr Pattern make_pattern()
{
    Pattern pattern{};
    for (uint32_t i = 0; i < kPoints; ++i) {
        const double radius = generate::root(i + 0.5);
        const double angle = 2 * generate::kPi * (generate::fraction(i / generate::kGolden) - 0.5);  // -π .. π, turned
        pattern.point[i] = {round_q12(-radius * generate::sine(angle + generate::kPi / 2)),
                            round_q12(-radius * generate::sine(angle))};
    }
    return pattern;
}

constexpr Pattern kPattern = make_pattern();

// Delaunay triangles that reach into the cap, by their lowest corner.
constexpr uint8_t kCorners[kTriangles][3] = {
    {0, 2, 1},   {0, 1, 3},   {1, 2, 4},   {0, 5, 2},   {0, 3, 8},   {0, 8, 5},   {1, 6, 3},  {1, 4, 9},
    {1, 9, 6},   {2, 7, 4},   {2, 5, 10},  {2, 15, 7},  {2, 10, 15}, {3, 6, 11},  {3, 16, 8}, {3, 11, 16},
    {4, 7, 12},  {4, 17, 9},  {4, 12, 17}, {5, 8, 13},  {5, 18, 10}, {5, 13, 18}, {6, 9, 14}, {6, 19, 11},
    {6, 14, 19}, {7, 20, 12}, {7, 15, 20}, {8, 21, 13}, {8, 16, 21}};

}  // namespace

PlanePoint plane_point(uint32_t i)
{
    return kPattern.point[i];
}

const uint8_t* corners(int k)
{
    return kCorners[k];
}

}  // namespace lumi::polar
