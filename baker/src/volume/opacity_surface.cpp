// SPDX-License-Identifier: MIT
#include "volume/opacity_surface.h"

#include "volume/iso_surface.h"

namespace lumi::baker
{
namespace
{

using Step = std::array<int32_t, 3>;

// The length of a step between voxels in the grid's world.
float length_of(const Grid& grid, const Step& step)
{
    double sum = 0;
    for (const auto& row : grid.voxel_to_world) {
        const double way = row[0] * step[0] + row[1] * step[1] + row[2] * step[2];
        sum += way * way;
    }
    return static_cast<float>(std::sqrt(sum));
}

// Light that comes along one step after the other, over the whole grid: depths from where it enters.
class Sweep
{
public:
    Sweep(const Grid& grid, const std::vector<float>& densities, const Step& step)
        : size_{static_cast<int32_t>(grid.nx), static_cast<int32_t>(grid.ny), static_cast<int32_t>(grid.nz)},
          densities_(densities),
          step_(step),
          half_(length_of(grid, step) / 2),
          back_((static_cast<ptrdiff_t>(step[2]) * size_[1] + step[1]) * size_[0] + step[0]),
          depths_(densities.size())
    {
    }

    // Lowers `least` to this light's depths.
    void run(std::vector<float>& least)
    {
        const auto at = [&](int k, size_t axis) { return step_[axis] < 0 ? size_[axis] - 1 - k : k; };
        for (int c = 0; c < size_[2]; ++c) {
            for (int b = 0; b < size_[1]; ++b) {
                const int y = at(b, 1), z = at(c, 2);
                const bool enters = leaves(y - step_[1], 1) || leaves(z - step_[2], 2);
                const ptrdiff_t row = (static_cast<ptrdiff_t>(z) * size_[1] + y) * size_[0];
                for (int a = 0; a < size_[0]; ++a) {
                    const int x = at(a, 0);
                    visit(row + x, enters || leaves(x - step_[0], 0), least);
                }
            }
        }
    }

private:
    bool leaves(int place, size_t axis) const { return place < 0 || place >= size_[axis]; }

    void visit(ptrdiff_t voxel, bool enters, std::vector<float>& least)
    {
        const auto here = static_cast<size_t>(voxel), before = static_cast<size_t>(voxel - back_);
        depths_[here] = enters ? 0 : depths_[before] + half_ * (densities_[before] + densities_[here]);
        least[here] = std::min(least[here], depths_[here]);
    }

    const Step size_;
    const std::vector<float>& densities_;
    const Step step_;
    const float half_;
    const ptrdiff_t back_;
    std::vector<float> depths_;
};

// Every so many voxels only, so that no side has more than kMostVoxels.
Grid coarser(const Grid& grid)
{
    constexpr uint32_t kMostVoxels = 112;  // a side; a mesh of some thousand triangles shows no more
    const uint32_t stride = (std::max({grid.nx, grid.ny, grid.nz}) + kMostVoxels - 1) / kMostVoxels;
    const auto left = [&](uint32_t n) { return std::max((n - 1) / stride + 1, 2u); };
    if (stride == 1 || std::min({grid.nx, grid.ny, grid.nz}) <= stride) return grid;
    Grid result;
    result.nx = left(grid.nx);
    result.ny = left(grid.ny);
    result.nz = left(grid.nz);
    result.voxel_to_world = grid.voxel_to_world;
    for (auto& row : result.voxel_to_world)
        for (size_t k = 0; k < 3; ++k) row[k] *= stride;
    for (uint32_t z = 0; z < result.nz; ++z) {
        for (uint32_t y = 0; y < result.ny; ++y) {
            const size_t row = (size_t{z} * grid.ny + y) * stride * grid.nx;  // where voxel stride·(0, y, z) is
            for (uint32_t x = 0; x < result.nx; ++x) result.values.push_back(grid.values[row + size_t{x} * stride]);
        }
    }
    return result;
}

}  // namespace

Grid optical_depths(const Volume& volume)
{
    Grid result = volume.grid;
    std::vector<float> densities;
    densities.reserve(result.values.size());
    for (const float v : volume.grid.values) densities.push_back(volume.transfer.density(v));
    std::fill(result.values.begin(), result.values.end(), std::numeric_limits<float>::max());
    for (int k = 0; k < 27; ++k) {
        const Step step = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        if (step != Step{0, 0, 0}) Sweep(result, densities, step).run(result.values);
    }
    return result;
}

Mesh opacity_surface(const Volume& volume)
{
    constexpr float kLog2 = 0.693147181f;
    return iso_surface(coarser(optical_depths(volume)), kLog2);
}

}  // namespace lumi::baker
