// SPDX-License-Identifier: MIT
// From where a surface field may be seen.
#pragma once

#include "geometry/accelerator.h"

namespace lumi::baker
{

// Eyes at any distance from the sphere's centre whose direction from it is at least so high: the cap of the sphere that
// lies above. What no such eye sees costs nothing.
class ViewCap
{
public:
    ViewCap() = default;
    // `share` is that of the sphere's area, 0 < share <= 1; 1: all around.
    explicit ViewCap(float share) : lowest_(1 - 2 * share) {}

    bool is_whole() const { return lowest_ <= -1; }
    float lowest() const { return lowest_; }
    // Whether such an eye, outside the sphere, may see along the line of this ray. The ray may begin anywhere on it.
    bool sees(const Ray& line) const;

private:
    float lowest_ = -1;
};

}  // namespace lumi::baker
