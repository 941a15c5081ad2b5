// SPDX-License-Identifier: MIT
// The part of a scene that can be seen from outside: a mesh has to follow it.
#pragma once

#include "geometry/accelerator.h"
#include "geometry/view_cap.h"
#include "scene/scene_data.h"
#include "util/job.h"

namespace lumi::baker
{

struct Outside {
    Mesh mesh;  // positions and corners; vertices welded; triangles turned towards the side that is seen more
    // By vertex: the share of directions from which the surface around it is seen, in the mean; 0 .. 1.
    std::vector<float> openness;
    bool two_sided = false;  // too much is seen from both sides to cull back faces

    Faces faces() const { return two_sided ? Faces::both : Faces::front; }
};

template <class Io>
void fields(Io& io, Outside& outside)
{
    io(outside.two_sided, outside.mesh, outside.openness);
}

// Positions and corners with vertices at one place as one, without triangles that are degenerate then.
Mesh welded(const Mesh& mesh);

Outside outside_of(const SceneData& scene, Job& job, const ViewCap& cap = {});

}  // namespace lumi::baker
