// SPDX-License-Identifier: MIT
// The lattice around a pole, where longitude and height stop being usable coordinates.
//
// Under Lambert's azimuthal equal-area projection, scaled so that a point covers an area of π, point i of *every*
// Spherical Fibonacci set lies at radius sqrt(i + 1/2) and longitude i/Φ: one planar pattern for all n. Its Delaunay
// triangles are therefore constants. tests/core/polar_test.cpp recomputes them by brute force.
#pragma once

#include <cstdint>

namespace lumi::polar
{

// Triangles cover the disc of radius sqrt(kCapHeight + 1/2): all directions whose real-valued index is below
// kCapHeight.
inline constexpr int32_t kCapHeight = 21;
inline constexpr uint32_t kPoints = 42;
inline constexpr int kTriangles = 61;

struct PlanePoint {
    int16_t x_q12, y_q12;
};

// Point i < kPoints of the pattern.
PlanePoint plane_point(uint32_t i);

// Corners of triangle k < kTriangles, counter-clockwise, the lowest index first. Triangles come in the order of it.
const uint8_t* corners(int k);

// The triangles across the edges opposite the corners of triangle k; kNone where the pattern's table ends.
inline constexpr uint8_t kNone = 255;
const uint8_t* beyond(int k);

}  // namespace lumi::polar
