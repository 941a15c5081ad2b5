// SPDX-License-Identifier: MIT
// Rays against a mesh as renderers see it: back faces are seen through unless the mesh is two-sided.
#pragma once

#include "geometry/accelerator.h"
#include "geometry/mesh.h"

namespace lumi::baker
{

class MeshTracer
{
public:
    // Reads only the positions and corners of `mesh`.
    MeshTracer(Mesh mesh, bool two_sided);

    const Mesh& mesh() const { return mesh_; }
    bool two_sided() const { return two_sided_; }
    std::optional<Hit> closest(const Ray& ray) const;
    // Whether the ray meets any triangle, from whichever side.

private:
    Mesh mesh_;
    bool two_sided_;
    std::optional<Accelerator> accelerator_;  // none where there is no triangle
};

}  // namespace lumi::baker
