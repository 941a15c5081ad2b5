// SPDX-License-Identifier: MIT
// How a part of a scene moves: it turns about an axis, or slides along it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "volume/affine.h"

namespace lumi::baker
{

// Places are in the frame of the mesh that the part belongs to.
struct PartMovement {
    std::string name;
    bool slides = false;
    Vec3 axis = {0, 0, 1};  // unit length
    Vec3 pivot;             // a point of the axis
    bool is_limited = false;
    double from = 0, to = 0;  // of its poses, where it is limited: degrees, right-handed, or lengths
    double value = 0;         // of the pose that is traced
    std::optional<double> lit_at = std::nullopt;

    // Leads from the mesh's pose, 0, to another.
    Affine pose(double value_of_pose) const;
    // The poses whose mean light it has in a field: lit_at, or so many of its range, which count alike.
    std::vector<double> lit_poses(size_t count) const;
};

// Parts of a mesh that move.
struct MovingParts {
    std::vector<PartMovement> motions;
    std::vector<uint8_t> owners;  // by triangle: 0 of the body, k of motions[k - 1]

    bool empty() const { return motions.empty(); }
    bool are_at_rest() const;
    // Where the corners of parts come in any admitted pose, nearly: the smallest sphere around these holds them.
    std::vector<Vec3> swept(const Mesh& mesh) const;
    // The mesh with every part in its pose.
    Mesh posed(Mesh mesh) const;
};

}  // namespace lumi::baker
