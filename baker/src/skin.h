// SPDX-License-Identifier: MIT
// How much of the light that arrives from one direction a rough dielectric skin reflects in all.
//
// Plastic needs it so that skin and body together conserve energy: what the skin does not reflect reaches the body.
// Kulla & Conty, "Revisiting Physically Based Shading at Imageworks", SIGGRAPH 2017 course.
#pragma once

#include <array>
#include <cstddef>

#include "vec3.h"

namespace lumi::baker
{

class Skin
{
public:
    // Tabulates by quadrature, some milliseconds. eta > 1, alpha > 0. The same arguments give the same table.
    Skin(float eta, float alpha);

    float eta() const { return eta_; }
    float alpha() const { return alpha_; }
    // cosine in [0, 1] of the direction's angle to the normal. Never below the true value by more than the quadrature's
    // error of 0.002, as the function is convex and interpolated.
    float albedo(float cosine) const;
    // Mean over a hemisphere of diffuse light.
    float mean_albedo() const { return mean_; }

private:
    static constexpr size_t kSteps = 64;

    float eta_, alpha_, mean_;
    std::array<float, kSteps + 1> table_;
};

}  // namespace lumi::baker
