// SPDX-License-Identifier: MIT
// Checks for every reflecting BSDF: densities that integrate to one and that samples follow, weights that are
// those of their direction, reciprocity, and energy that neither appears nor vanishes.
#pragma once

#include <string>
#include <vector>

#include "material/material.h"

namespace lumi::baker::testing
{

// A material's values at a point of a surface without textures.
inline PointValues plain_values(const Material& m)
{
    return {m.base, m.metalness, 1, true, m.sheen};
}

inline constexpr double kQuadrature = 0.002;  // error of a skin's table

struct Named {
    std::string name;
    Bsdf bsdf;
};

// With one digit behind the point, or two below 0.1.
std::string short_text(float number);

// Heights from straight above to grazing, at one azimuth.
std::vector<Vec3> views(float turns = 0.13f);

// `steps` cells a bin's side: narrow lobes need more.
void check_density(const Named& named, const std::vector<Vec3>& viewers, int steps = 8);
void check_weights(const Named& named, const std::vector<Vec3>& viewers);
void check_reciprocal(const Named& named);

// Checks that a white BSDF gains no more than `tolerance` and returns the most that it surely loses.
double checked_loss(const Named& named, const std::vector<Vec3>& viewers, double tolerance = kQuadrature);

}  // namespace lumi::baker::testing
