// SPDX-License-Identifier: MIT
#include "metrics/spectrum.h"

#include <fftw3.h>

#include <algorithm>

namespace lumi::tools
{

namespace
{

// std::complex<double> and fftw_complex are layout-compatible by both libraries' documentation.
Plane<Complex> transform_in_place(Plane<Complex> plane, int sign)
{
    auto* data = reinterpret_cast<fftw_complex*>(plane.values.data());
    const fftw_plan plan = fftw_plan_dft_2d(plane.height_px, plane.width_px, data, data, sign, FFTW_ESTIMATE);
    fftw_execute(plan);
    fftw_destroy_plan(plan);
    return plane;
}

}  // namespace

Plane<Complex> forward_transform(const Plane<double>& plane)
{
    Plane<Complex> complex(plane.width_px, plane.height_px);
    std::copy(plane.values.begin(), plane.values.end(), complex.values.begin());
    return transform_in_place(std::move(complex), FFTW_FORWARD);
}

Plane<Complex> inverse_transform(Plane<Complex> spectrum)
{
    return transform_in_place(std::move(spectrum), FFTW_BACKWARD);
}

}  // namespace lumi::tools
