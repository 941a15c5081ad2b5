// SPDX-License-Identifier: MIT
// Rays against a mesh as renderers see it: where they draw front faces only, rays pass its back faces.
#pragma once

#include "geometry/accelerator.h"
#include "geometry/mesh.h"
#include "geometry/view_cap.h"
#include "util/job.h"

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
    // Returns the hit along a ray that is nearest to `distance`, at most `reach` from it.
    std::optional<Hit> near(const Ray& ray, float distance, float reach) const;

private:
    Mesh mesh_;
    Faces faces_;
    std::optional<Accelerator> accelerator_;  // none where there is no triangle
};

// Which triangles of a mesh can be seen from around.

// A triangle that none of so many rays meets counts as hidden. Where both of its sides count, each gets half of them.
inline constexpr uint32_t kSeenRays = 2048;

// The tracer's mesh without the triangles that nobody outside can see: each gets `rays`, in many directions, before it
// counts as such. Positions stay as they are. Where rays meet both faces, each side that is seen becomes a triangle
// that faces that way, so that the two can have colours of their own. The result is always a mesh of front faces.
Mesh seen_part(const MeshTracer& tracer, Job& job, const ViewCap& cap = {}, uint32_t rays = kSeenRays);

}  // namespace lumi::baker
