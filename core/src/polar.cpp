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
    {0, 2, 1},    {0, 1, 3},    {0, 5, 2},    {0, 3, 8},    {0, 8, 5},    {1, 2, 4},    {1, 6, 3},    {1, 4, 9},
    {1, 9, 6},    {2, 7, 4},    {2, 5, 10},   {2, 15, 7},   {2, 10, 15},  {3, 6, 11},   {3, 16, 8},   {3, 11, 16},
    {4, 7, 12},   {4, 17, 9},   {4, 12, 17},  {5, 8, 13},   {5, 18, 10},  {5, 13, 18},  {6, 9, 14},   {6, 19, 11},
    {6, 14, 19},  {7, 20, 12},  {7, 15, 20},  {8, 21, 13},  {8, 16, 21},  {9, 22, 14},  {9, 17, 30},  {9, 30, 22},
    {10, 23, 15}, {10, 18, 31}, {10, 31, 23}, {11, 24, 16}, {11, 19, 32}, {11, 32, 24}, {12, 25, 17}, {12, 20, 33},
    {12, 33, 25}, {13, 26, 18}, {13, 21, 34}, {13, 34, 26}, {14, 27, 19}, {14, 22, 35}, {14, 35, 27}, {15, 28, 20},
    {15, 23, 36}, {15, 36, 28}, {16, 29, 21}, {16, 24, 37}, {16, 37, 29}, {17, 25, 38}, {17, 38, 30}, {18, 26, 39},
    {18, 39, 31}, {19, 27, 40}, {19, 40, 32}, {20, 28, 41}, {20, 41, 33}};

// The triangle beyond the edge opposite each corner.
constexpr uint8_t kBeyond[kTriangles][3] = {
    {5, 1, 2},     {6, 3, 0},     {10, 0, 4},    {14, 4, 1},    {19, 2, 3},    {9, 7, 0},     {13, 1, 8},
    {17, 8, 5},    {22, 6, 7},    {16, 5, 11},   {20, 12, 2},   {26, 9, 12},   {32, 11, 10},  {23, 15, 6},
    {28, 3, 15},   {35, 14, 13},  {25, 18, 9},   {30, 7, 18},   {38, 17, 16},  {27, 21, 4},   {33, 10, 21},
    {41, 20, 19},  {29, 24, 8},   {36, 13, 24},  {44, 23, 22},  {39, 16, 26},  {47, 25, 11},  {42, 19, 28},
    {50, 27, 14},  {45, 22, 31},  {54, 31, 17},  {255, 29, 30}, {48, 12, 34},  {56, 34, 20},  {255, 32, 33},
    {51, 15, 37},  {58, 37, 23},  {255, 35, 36}, {53, 18, 40},  {60, 40, 25},  {255, 38, 39}, {55, 21, 43},
    {255, 43, 27}, {255, 41, 42}, {57, 24, 46},  {255, 46, 29}, {255, 44, 45}, {59, 26, 49},  {255, 49, 32},
    {255, 47, 48}, {255, 28, 52}, {255, 52, 35}, {255, 50, 51}, {255, 54, 38}, {255, 30, 53}, {255, 56, 41},
    {255, 33, 55}, {255, 58, 44}, {255, 36, 57}, {255, 60, 47}, {255, 39, 59}};

}  // namespace

PlanePoint plane_point(uint32_t i)
{
    return kPattern.point[i];
}

const uint8_t* corners(int k)
{
    return kCorners[k];
}

const uint8_t* beyond(int k)
{
    return kBeyond[k];
}

}  // namespace lumi::polar
