// SPDX-License-Identifier: MIT
// The largest density in each block of a volume: a ray passes empty blocks without a look, and takes steps in the
// others that suit their densest part.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "volume/grid.h"
#include "volume/transfer_function.h"

namespace lumi::baker
{

// A ray in voxel coordinates: where it is after `t` of the units of its direction, which is no unit vector.
struct VoxelRay {
    Vec3 origin, direction;
    Vec3 at(float t) const { return origin + direction * t; }
};

class Majorants
{
public:
    static constexpr uint32_t kBlock = 8;  // cells between voxel centres, a side

    Majorants(const Grid& grid, const TransferFunction& transfer);

    float most() const;
    // Calls use(t0, t1, majorant) for each block along the ray between the two, as long as it returns true.
    template <class Use>
    void walk(const VoxelRay& ray, float start, float end, const Use& use) const;
    // Corners, in voxel coordinates, of the blocks that are not empty.
    std::vector<Vec3> corners() const;

private:
    float at(const std::array<int32_t, 3>& block) const
    {
        return blocks_[static_cast<size_t>((block[2] * counts_[1] + block[1]) * counts_[0] + block[0])];
    }

    std::array<uint32_t, 3> cells_;  // cells along each side of the grid
    std::array<int32_t, 3> counts_;  // blocks along each side
    std::vector<float> blocks_;      // x fastest
};

// From block to block as the ray goes: J. Amanatides and A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing",
// Eurographics 1987.
template <class Use>
void Majorants::walk(const VoxelRay& ray, float start, float end, const Use& use) const
{
    constexpr float kSide = kBlock;
    const Vec3 first = ray.at(start);
    const std::array<float, 3> place = {first.x, first.y, first.z};
    const std::array<float, 3> origin = {ray.origin.x, ray.origin.y, ray.origin.z};
    const std::array<float, 3> way = {ray.direction.x, ray.direction.y, ray.direction.z};
    std::array<int32_t, 3> block, step;
    std::array<float, 3> next, width;  // t of the next border, and from border to border
    for (size_t k = 0; k < 3; ++k) {
        block[k] = std::clamp(static_cast<int32_t>(place[k] / kSide), 0, counts_[k] - 1);
        step[k] = way[k] > 0 ? 1 : -1;
        const float border = static_cast<float>(block[k] + (way[k] > 0 ? 1 : 0)) * kSide;
        next[k] = way[k] != 0 ? (border - origin[k]) / way[k] : std::numeric_limits<float>::infinity();
        width[k] = kSide / std::abs(way[k]);
    }
    for (float t = start; t < end;) {
        const size_t k = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
        const float border = std::min(next[k], end);
        if (border > t && !use(t, border, at(block))) return;
        t = std::max(t, border);
        block[k] += step[k];
        next[k] += width[k];
        if (block[k] < 0 || block[k] >= counts_[k]) return;
    }
}

}  // namespace lumi::baker
