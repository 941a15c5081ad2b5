// SPDX-License-Identifier: MIT
// Volumes made in memory.
#pragma once

#include "math/sampler.h"
#include "volume/volume.h"

namespace lumi::baker::testing
{

// A grid over the box between two corners, its values by `value(x, y, z)` of the voxel's place.
template <class Value>
Grid grid_of(uint32_t nx, uint32_t ny, uint32_t nz, const Vec3& low, const Vec3& high, const Value& value)
{
    Grid grid;
    grid.nx = nx;
    grid.ny = ny;
    grid.nz = nz;
    const Vec3 step = {(high.x - low.x) / static_cast<float>(nx - 1), (high.y - low.y) / static_cast<float>(ny - 1),
                       (high.z - low.z) / static_cast<float>(nz - 1)};
    grid.voxel_to_world[0] = {static_cast<double>(step.x), 0, 0, static_cast<double>(low.x)};
    grid.voxel_to_world[1] = {0, static_cast<double>(step.y), 0, static_cast<double>(low.y)};
    grid.voxel_to_world[2] = {0, 0, static_cast<double>(step.z), static_cast<double>(low.z)};
    for (uint32_t k = 0; k < nz; ++k) {
        for (uint32_t j = 0; j < ny; ++j) {
            for (uint32_t i = 0; i < nx; ++i) {
                grid.values.push_back(value(low.x + step.x * static_cast<float>(i),
                                            low.y + step.y * static_cast<float>(j),
                                            low.z + step.z * static_cast<float>(k)));
            }
        }
    }
    return grid;
}

inline Volume fog(float density, const Rgb& colour, const Vec3& low, const Vec3& high)
{
    return {grid_of(
                2, 2, 2, low, high, [](float, float, float) { return 1.0f; }),
            TransferFunction({{1, colour, density}})};
}

// Random values in some corners of a box, nothing in the others; denser and redder where they are higher.
inline Volume smoke(float anisotropy = 0.4f)
{
    Sampler sampler(77, 0, 0);
    const auto value = [&](float x, float y, float z) { return x + y + z > 0.1f ? 0 : 10 * sampler.next_1d(); };
    Volume result = {
        grid_of(20, 17, 29, {-0.5f, -0.45f, -0.5f}, {0.5f, 0.4f, 0.45f}, value),
        TransferFunction({{2, {0.3f, 0.6f, 0.9f}, 0}, {5, {0.9f, 0.8f, 0.7f}, 6}, {9, {1, 0.5f, 0.2f}, 3}}),
        anisotropy};
    return result;
}

}  // namespace lumi::baker::testing
