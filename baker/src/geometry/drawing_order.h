// SPDX-License-Identifier: MIT
// In which order faces that are seen from one side alone are drawn over each other.
//
// Where both face the eye, face A can hide face B only from places in front of both, so only where A lies in front of
// B's plane and B behind A's. For most pairs of faces that holds one way alone: the two faces of a pane are such a
// pair, and so are the near and the far wall of a bottle. Hence there mostly is one order that is right from
// everywhere. To sort by depth is wrong where a face is large beside the distance to the next one.
#pragma once

#include <vector>

#include "geometry/mesh.h"
#include "util/job.h"

namespace lumi::baker
{

// Triangles that wind counter-clockwise on the side from where they are seen. Neighbours in the list with the same
// number of a face are drawn together; numbers begin with 0 and rise by 1.
struct OneSidedFaces {
    const Mesh& triangles;
    const std::vector<uint32_t>& face_of;  // by triangle

    uint32_t count() const { return face_of.empty() ? 0 : face_of.back() + 1; }
};

// The faces, those first that others hide: no face moved alone makes it right for more light. Takes a number for each
// pair of faces.
std::vector<uint32_t> drawing_order(const OneSidedFaces& faces, Job& job);

// Returns, of the pairs of triangles that light passes one after the other on its way to an eye, the share that is
// drawn the wrong way round.
struct OrderFaults {
    uint32_t pairs = 0;
    double in_order = 0;
    double by_depth = 0;  // renderers that know no order go by the nearest corners
};
OrderFaults order_faults(const OneSidedFaces& faces, const std::vector<uint32_t>& order, Job& job);

}  // namespace lumi::baker
