// SPDX-License-Identifier: MIT
// Finds what hangs together: sets of numbers that are joined, and the sets of triangles that share vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "geometry/mesh.h"

namespace lumi::baker
{

// A union-find structure over the numbers below a count.
class DisjointSets
{
public:
    // Each number below `count` is a set of its own.
    explicit DisjointSets(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    // All members of a set have the same number.
    uint32_t root(uint32_t number)
    {
        while (parent_[number] != number) number = parent_[number] = parent_[parent_[number]];
        return number;
    }
    void join(uint32_t a, uint32_t b) { parent_[root(a)] = root(b); }

private:
    std::vector<uint32_t> parent_;
};

// The sets of triangles that share vertices.
class Components
{
public:
    explicit Components(const Mesh& mesh) : sets_(mesh.positions.size())
    {
        for (const Mesh::Corners& c : mesh.corners) {
            sets_.join(c[0], c[1]);
            sets_.join(c[0], c[2]);
        }
    }

    // All of a component has the same number, which is below that of the mesh's vertices.
    uint32_t of(uint32_t vertex) { return sets_.root(vertex); }
    uint32_t of(const Mesh::Corners& corners) { return of(corners[0]); }

private:
    DisjointSets sets_;
};

}  // namespace lumi::baker
