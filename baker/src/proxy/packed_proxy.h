// SPDX-License-Identifier: MIT
// A proxy mesh as field files hold it (lumi/guided_format.h).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace lumi::baker
{

// Vertices in steps of 1/2048 of the sphere's radius; triangles counter-clockwise seen from outside.
struct PackedProxy {
    using Triple = std::array<uint16_t, 3>;  // 12 bits each
    std::vector<Triple> vertices, triangles;
    bool two_sided = false;
};

}  // namespace lumi::baker
