// SPDX-License-Identifier: MIT
// Sets of triangles that share vertices.
#pragma once

#include "geometry/mesh.h"
#include "util/disjoint_sets.h"

namespace lumi::baker
{

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
