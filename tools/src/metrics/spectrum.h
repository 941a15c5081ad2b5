// SPDX-License-Identifier: MIT
// Discrete Fourier transforms of planes. spectrum.cpp is the only file that sees kissfft.
#pragma once

#include <complex>

#include "image/plane.h"

namespace lumi::tools
{

using Complex = std::complex<double>;

// Coefficient (u, v) of a spectrum stands at column u mod width, row v mod height; forward has no factor,
// inverse none either: inverse(forward(p)) = width·height·p.
Plane<Complex> forward_transform(const Plane<double>& plane);
Plane<Complex> inverse_transform(Plane<Complex> spectrum);

}  // namespace lumi::tools
