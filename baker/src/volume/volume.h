// SPDX-License-Identifier: MIT
// A reader of a scene file delivers this of a medium, in its scene's units and axes.
#pragma once

#include <cstddef>
#include <vector>

#include "math/vec3.h"
#include "volume/grid.h"

namespace lumi::baker
{

struct TransferPoint {
    float value;
    Rgb colour;     // albedo of a scattering, 0 to 1
    float density;  // extinction, 1 / length, at least 0
};

// Tells the look of a volume's scalars: how much of light it stops along a unit of length, and the colour of what it
// scatters. It is linear between its points; before the first and behind the last it stays as it is there.
class TransferFunction
{
public:
    // Takes at least one point; values strictly increase.
    explicit TransferFunction(std::vector<TransferPoint> points);

    float density(float value) const;
    Rgb colour(float value) const;
    // Returns the largest density of all scalars from `low` to `high`.
    float most_density(float low, float high) const;

    const std::vector<TransferPoint>& points() const { return points_; }

private:
    // The two points around a scalar and how far it lies from the first to the second; twice the same outside.
    struct Place {
        const TransferPoint &from, &to;
        float share;
    };
    Place place(float value) const;

    std::vector<TransferPoint> points_;
};

struct Volume {
    Grid grid;  // two voxels or more a side, of finite values; its matrix can be inverted
    TransferFunction transfer;
    float anisotropy = 0;  // mean cosine of a scattering
};

// Corners, in the scene's units and axes, of the parts of the grid that hold any density; none if it is empty.
std::vector<Vec3> corners_of(const Volume& volume);

}  // namespace lumi::baker
