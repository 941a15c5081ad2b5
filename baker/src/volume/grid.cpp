// SPDX-License-Identifier: MIT
#include "volume/grid.h"

#include <cmath>

#include "lumi/baker/scene.h"
#include "util/text_lines.h"

namespace lumi::baker
{

void require_size(const std::string& name, const std::array<int64_t, 3>& sides)
{
    int64_t voxels = 1;
    for (size_t k = 0; k < 3; ++k) {
        if (sides[k] < 2 || sides[k] > kMaxVoxelsASide) {
            throw SceneError(at({name}, std::to_string(sides[k]) + " voxels along axis " + std::to_string(k + 1) +
                                            "; a volume has 2 to " + std::to_string(kMaxVoxelsASide)));
        }
        voxels *= sides[k];
    }
    if (voxels > kMaxVoxels) {
        throw SceneError(at({name}, std::to_string(voxels) + " voxels; at most " + std::to_string(kMaxVoxels) +
                                        " are read: crop the volume, or resample it with larger voxels"));
    }
}

void require_place(const std::string& name, const Affine& voxel_to_world, const std::string& method)
{
    constexpr double kFarthest = 1e9, kSmallestVoxel = 1e-18;  // units of the file, and their cube
    for (const auto& row : voxel_to_world) {
        for (const double entry : row) {
            if (!(std::abs(entry) <= kFarthest)) {
                throw SceneError(at({name}, "the header does not say where voxels lie: its " + method + " holds " +
                                                std::to_string(entry) + "; write the file anew with a true " + method));
            }
        }
    }
    if (!(std::abs(determinant(voxel_to_world)) >= kSmallestVoxel)) {
        throw SceneError(
            at({name}, "voxels have no volume by the header's " + method + "; write the file anew with their size"));
    }
}

}  // namespace lumi::baker
