// SPDX-License-Identifier: MIT
// The complex steerable pyramid, computed in the frequency domain.
//
// Portilla, Simoncelli, "A Parametric Texture Model Based on Joint Statistics of Complex Wavelet Coefficients",
// IJCV 40(1), 2000, section 2.1. Level s passes spatial frequencies of one octave around 2^-(s+2) cycles per pixel;
// orientation k passes directions around k·π/kOrientations by cos^(kOrientations-1), one half of the plane only, so
// that a coefficient is complex: its modulus is the local amplitude in grey levels, its phase where the structure lies.
// Bands are decimated by 2^s by cropping the spectrum. The picture is taken to repeat periodically.
#pragma once

#include <complex>

#include "image/picture.h"

namespace lumi::tools
{

// Discrete Fourier transforms of planes. steerable_pyramid.cpp is the only file that sees kissfft.

using Complex = std::complex<double>;

// Coefficient (u, v) of a spectrum stands at column u mod width, row v mod height; forward has no factor,
// inverse none either: inverse(forward(p)) = width·height·p.
Plane<Complex> forward_transform(const Plane<double>& plane);
Plane<Complex> inverse_transform(Plane<Complex> spectrum);

inline constexpr int kOrientations = 16;

class SteerablePyramid
{
public:
    explicit SteerablePyramid(const Plane<double>& plane);

    // Level >= 0, 0 <= orientation < kOrientations. Cost: one inverse transform of the band's size.
    Plane<Complex> band(int level, int orientation) const;

private:
    Plane<Complex> spectrum_;
};

// The side of a band of level `level` of a plane whose side is `side_px`.
constexpr int band_side(int side_px, int level)
{
    return (side_px + (1 << level) - 1) >> level;
}

// The factors that a band's filter consists of, at spatial frequency (fx, fy) in cycles per pixel. For every frequency,
// the squares of all levels' radial factors sum to 1 below half of Nyquist's, down to the lowest level's octave, and so
// do the squares of all orientations' angular factors, both half planes together.
double radial_factor(int level, double fx, double fy);
double angular_factor(int orientation, double fx, double fy);

}  // namespace lumi::tools
