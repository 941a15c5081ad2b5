// SPDX-License-Identifier: MIT
// Node colours whose trilinear interpolation comes closest to colours at points of the surface.
#pragma once

#include "guided/mean_voxels.h"

namespace lumi::baker
{

class MeanFit
{
public:
    explicit MeanFit(const NodeGrid& grid);  // borrows it

    void add(const Vec3& x, const Levels& colour);
    // Least squares, with a little smoothness between neighbours, which also gives nodes without points a colour.
    std::vector<Levels> solve() const;

private:
    static constexpr size_t kStencil = 27;

    std::vector<Levels> apply(const std::vector<Levels>& x) const;

    const NodeGrid& grid_;
    std::vector<float> matrix_;  // of each node and its neighbours, x fastest
    std::vector<Levels> right_side_;
    std::vector<uint32_t> neighbours_;
};

}  // namespace lumi::baker
