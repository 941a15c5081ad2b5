// SPDX-License-Identifier: MIT
#include "volume/volume.h"

namespace lumi::baker
{

TransferFunction::TransferFunction(std::vector<TransferPoint> points) : points_(std::move(points)) {}

TransferFunction::Place TransferFunction::place(float value) const
{
    const auto above = std::find_if(points_.begin(), points_.end(), [&](const auto& p) { return p.value > value; });
    if (above == points_.begin()) return {points_.front(), points_.front(), 0};
    if (above == points_.end()) return {points_.back(), points_.back(), 0};
    const TransferPoint& from = *(above - 1);
    return {from, *above, (value - from.value) / (above->value - from.value)};
}

float TransferFunction::density(float value) const
{
    const Place p = place(value);
    return p.from.density + (p.to.density - p.from.density) * p.share;
}

Rgb TransferFunction::colour(float value) const
{
    const Place p = place(value);
    return p.from.colour + (p.to.colour - p.from.colour) * p.share;
}

float TransferFunction::most_density(float low, float high) const
{
    float most = std::max(density(low), density(high));
    for (const TransferPoint& p : points_) most = p.value > low && p.value < high ? std::max(most, p.density) : most;
    return most;
}

}  // namespace lumi::baker
