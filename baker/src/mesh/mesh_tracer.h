// SPDX-License-Identifier: MIT
// Rays against a mesh as renderers see it: where they draw front faces only, rays pass its back faces.
#pragma once

#include "geometry/accelerator.h"
#include "geometry/mesh.h"

namespace lumi::baker
{

class MeshTracer
{
public:
    // Reads only the positions and corners of `mesh`.
    MeshTracer(Mesh mesh, Faces faces);

    const Mesh& mesh() const { return mesh_; }
    Faces faces() const { return faces_; }
    std::optional<Hit> closest(const Ray& ray) const;
    // Of the hits along a ray the one nearest to `distance`, at most `reach` from it.
    std::optional<Hit> near(const Ray& ray, float distance, float reach) const;

private:
    Mesh mesh_;
    Faces faces_;
    std::optional<Accelerator> accelerator_;  // none where there is no triangle
};

}  // namespace lumi::baker
