// SPDX-License-Identifier: MIT
// Facets that spread wider along one direction than across it: by 1/aspect, and by aspect. Burley, "Physically Based
// Shading at Disney", SIGGRAPH 2012 course, section 5.4.
#pragma once

#include <algorithm>
#include <cmath>

namespace lumi::baker
{

inline constexpr float kMostStretch = 0.9f;

// `anisotropy` in [0, 1].
inline float aspect_of(float anisotropy)
{
    return std::sqrt(1 - kMostStretch * anisotropy);
}

// The anisotropy of facets that are `ratio` times as wide along as across, which is 1 or more; 10 and more are 1.
inline float anisotropy_of(float ratio)
{
    return std::min((1 - 1 / ratio) / kMostStretch, 1.0f);
}

}  // namespace lumi::baker
