// SPDX-License-Identifier: MIT
#include "guided/chart_occlusion.h"

namespace lumi::baker
{
namespace
{

constexpr float kMargin = 0.03f;    // radii behind what an origin sees, that still count as seen
constexpr float kDepthSteps = 128;  // a radius
constexpr uint8_t kHidesNothing = 255;

class Depths
{
public:
    explicit Depths(uint32_t side) : side_(side), farthest_(size_t{side} * side, 0) {}

    // A grid point counts for the blocks of its diagonal neighbours, too: their taps read it.
    void add(uint32_t u, uint32_t v, float distance)
    {
        for (uint32_t corner = 0; corner < 4; ++corner) {
            const uint32_t x = (u + 2 * (corner & 1) - 1) >> format::kOcclusionShift;
            const uint32_t y = (v + 2 * (corner >> 1) - 1) >> format::kOcclusionShift;
            if (std::max(x, y) < side_) {
                float& far = farthest_[size_t{y} * side_ + x];
                far = std::max(far, distance);
            }
        }
    }

    uint8_t packed(uint32_t x, uint32_t y) const
    {
        const float far = farthest_[size_t{y} * side_ + x];
        const float steps = std::ceil((far + kMargin) * kDepthSteps);
        return far > 0 ? static_cast<uint8_t>(std::min<float>(steps, kHidesNothing)) : kHidesNothing;
    }

private:
    uint32_t side_;
    std::vector<float> farthest_;
};

}  // namespace

PackedChart chart_occlusion(const ChartMask& mask, const ChartRows& rows, const std::vector<float>& farthest)
{
    const ChartMask blocks = mask.blocks(format::kOcclusionShift);
    Depths depths(blocks.side());
    for (uint32_t r = 0; r < rows.rows.size(); ++r) {
        const ChartRows::Row& row = rows.rows[r];
        for (uint32_t k = 0; k < row.count; ++k) {
            depths.add(row.first_u + k, rows.first_v + r, farthest[row.at + k]);
        }
    }
    PackedChart result = {blocks.rows(), {}};
    for (uint32_t r = 0; r < result.rows.rows.size(); ++r) {
        const ChartRows::Row& row = result.rows.rows[r];
        for (uint32_t k = 0; k < row.count; ++k) {
            result.texels.push_back(depths.packed(row.first_u + k, result.rows.first_v + r));
        }
    }
    return result;
}

}  // namespace lumi::baker
