// SPDX-License-Identifier: MIT
#include "volume/majorants.h"

namespace lumi::baker
{
namespace
{

int32_t blocks_of(uint32_t cells)
{
    return static_cast<int32_t>((cells + Majorants::kBlock - 1) / Majorants::kBlock);
}

// The largest density among the cells from `low` to `high`; both borders' voxels count.
float most_between(const Grid& grid, const TransferFunction& transfer, const std::array<uint32_t, 3>& low,
                   const std::array<uint32_t, 3>& high)
{
    float least = std::numeric_limits<float>::infinity(), most = -least;
    for (uint32_t z = low[2]; z <= high[2]; ++z) {
        for (uint32_t y = low[1]; y <= high[1]; ++y) {
            const float* row = grid.values.data() + (size_t{z} * grid.ny + y) * grid.nx;
            const auto [a, b] = std::minmax_element(row + low[0], row + high[0] + 1);
            least = std::min(least, *a);
            most = std::max(most, *b);
        }
    }
    constexpr float kRounding = 1e-6f;  // bounds the rounding of interpolation between voxels and between points
    return transfer.most_density(least, most) * (1 + kRounding);
}

}  // namespace

Majorants::Majorants(const Grid& grid, const TransferFunction& transfer)
    : cells_{grid.nx - 1, grid.ny - 1, grid.nz - 1},
      counts_{blocks_of(cells_[0]), blocks_of(cells_[1]), blocks_of(cells_[2])}
{
    const auto bounds = [&](std::array<uint32_t, 3> block, uint32_t more) {
        for (size_t k = 0; k < 3; ++k) block[k] = std::min((block[k] + more) * kBlock, cells_[k]);
        return block;
    };
    for (uint32_t z = 0; z < static_cast<uint32_t>(counts_[2]); ++z) {
        for (uint32_t y = 0; y < static_cast<uint32_t>(counts_[1]); ++y)
            for (uint32_t x = 0; x < static_cast<uint32_t>(counts_[0]); ++x)
                blocks_.push_back(most_between(grid, transfer, bounds({x, y, z}, 0), bounds({x, y, z}, 1)));
    }
}

float Majorants::most() const
{
    return *std::max_element(blocks_.begin(), blocks_.end());
}

std::vector<Vec3> Majorants::corners() const
{
    std::vector<Vec3> result;
    const auto place = [&](int32_t block, int bit, size_t k) {
        return static_cast<float>(std::min((static_cast<uint32_t>(block + bit)) * kBlock, cells_[k]));
    };
    std::array<int32_t, 3> b;
    for (b[2] = 0; b[2] < counts_[2]; ++b[2]) {
        for (b[1] = 0; b[1] < counts_[1]; ++b[1]) {
            for (b[0] = 0; b[0] < counts_[0]; ++b[0]) {
                for (int corner = 0; corner < 8 && at(b) > 0; ++corner) {
                    result.push_back(
                        {place(b[0], corner & 1, 0), place(b[1], corner >> 1 & 1, 1), place(b[2], corner >> 2, 2)});
                }
            }
        }
    }
    return result;
}

}  // namespace lumi::baker
