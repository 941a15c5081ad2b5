// SPDX-License-Identifier: MIT
// From radiance to encoded levels as straight lines, for fits to noisy light.
//
// Levels are a concave function of radiance: the mean of encoded samples is darker than the encoded mean. A line
// through the point where the mean is expected keeps the mean.
#pragma once

#include <array>
#include <vector>

#include "image/tone.h"

namespace lumi::baker
{

using LevelColour = std::array<float, 3>;  // encoded, 0 .. 255; of a fit also a little beyond

// levels + slope · (radiance - at)
struct ToneLine {
    Rgb at;
    LevelColour levels;
    std::array<std::array<float, 3>, 3> slope;

    LevelColour operator()(const Rgb& radiance) const;
    // The radiance at which the line has these levels.
    Rgb inverse(const LevelColour& wanted) const;
};

class EncodedTone
{
public:
    explicit EncodedTone(ToneCurve curve);

    // The levels of a radiance, without a clip above 255.
    LevelColour encoded(const Rgb& radiance) const;
    // The tangent at about these levels.
    ToneLine line_at(const LevelColour& levels) const;
    // Returns the same line, but not so flat that a few levels may be any light: x % less light is x/4 % fewer levels
    // at least.
    ToneLine invertible_line_at(const LevelColour& levels) const;

private:
    struct Step {
        float level, linear, slope;  // a point of the transfer function, and its slope there
    };
    const Step& step_at(float level) const;

    ToneCurve curve_;
    std::vector<Step> steps_;
};

}  // namespace lumi::baker
