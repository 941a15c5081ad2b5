// SPDX-License-Identifier: MIT
// View-averaged colours at the nodes of a sparse grid over the sphere's cube, trilinear in between.
#pragma once

#include "geometry/mesh.h"
#include "guided/guided_parts.h"

namespace lumi::baker
{

// Encoded values, 0 to 255.
struct Levels {
    float r = 0, g = 0, b = 0;
};
constexpr Levels operator+(const Levels& a, const Levels& b)
{
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
constexpr Levels operator-(const Levels& a, const Levels& b)
{
    return {a.r - b.r, a.g - b.g, a.b - b.b};
}
constexpr Levels operator*(const Levels& a, float s)
{
    return {a.r * s, a.g * s, a.b * s};
}

// The nodes that look-ups near a surface touch.
class NodeGrid
{
public:
    static constexpr uint32_t kNone = ~uint32_t{0};

    // Every look-up within 1/128 radius of `surface`.
    NodeGrid(const Mesh& surface, uint32_t resolution);

    struct Lookup {
        uint32_t node[8];  // kNone: not one of the grid's
        float weight[8];
    };
    Lookup lookup(const Vec3& x) const;

    uint32_t resolution() const { return resolution_; }
    uint32_t side() const { return resolution_ + 2; }  // nodes along each axis
    size_t size() const { return places_.size(); }
    // The node's place among all of the cube: x + side·(y + side·z).
    uint32_t place(size_t node) const { return places_[node]; }
    uint32_t at(uint32_t x, uint32_t y, uint32_t z) const { return numbers_[(size_t{z} * side() + y) * side() + x]; }

private:
    struct Cell {
        uint32_t corner[3];
        float part[3];
    };
    Cell cell(const Vec3& x) const;
    void mark(const Vec3& x);
    void mark_triangle(const Vec3& a, const Vec3& b, const Vec3& c);

    uint32_t resolution_;
    std::vector<uint32_t> numbers_;  // of all nodes of the cube
    std::vector<uint32_t> places_;
};

// Trilinear between colours of the grid's nodes; nodes that it lacks count as black.
Levels trilinear(const NodeGrid& grid, const std::vector<Levels>& colours, const Vec3& x);

// Packs the colours, and changes each to what a reader will see.
PackedMean packed_mean(const NodeGrid& grid, std::vector<Levels>& colours, format::MeanFormat format);

}  // namespace lumi::baker
