// SPDX-License-Identifier: MIT
#include "metrics/metrics.h"

#include <algorithm>

#include "metrics/steerable_pyramid.h"

namespace lumi::tools
{

namespace
{

constexpr double kK = 1;

int levels_with_room(int width, int height)
{
    int levels = 1;
    while (levels < kCwSsimMaxLevels && band_side(std::min(width, height), levels) >= kCwSsimWindow) ++levels;
    return levels;
}

double similarity_of_bands(const Plane<Complex>& a, const Plane<Complex>& b)
{
    const std::vector<double> box(kCwSsimWindow, 1.0 / kCwSsimWindow);
    Plane<Complex> cross(a.width_px, a.height_px);
    Plane<double> energy(a.width_px, a.height_px);
    for (size_t i = 0; i < cross.values.size(); ++i) {
        cross.values[i] = a.values[i] * std::conj(b.values[i]);
        energy.values[i] = std::norm(a.values[i]) + std::norm(b.values[i]);
    }
    cross = filter_valid(cross, box);
    energy = filter_valid(energy, box);
    double sum = 0;
    for (size_t i = 0; i < cross.values.size(); ++i)
        sum += (2 * std::abs(cross.values[i]) + kK) / (energy.values[i] + kK);
    return sum / static_cast<double>(cross.values.size());
}

}  // namespace

double cw_ssim(const Picture& picture_a, const Picture& picture_b)
{
    check_precondition(same_size(picture_a, picture_b), "pictures of two sizes cannot be compared");
    check_precondition(picture_a.width_px >= kCwSsimWindow && picture_a.height_px >= kCwSsimWindow,
                       "the pictures are smaller than a window of CW-SSIM");
    const SteerablePyramid a(luma_plane(picture_a)), b(luma_plane(picture_b));
    const int levels = levels_with_room(picture_a.width_px, picture_a.height_px);
    double sum = 0;
    for (int level = 0; level < levels; ++level)
        for (int orientation = 0; orientation < kOrientations; ++orientation)
            sum += similarity_of_bands(a.band(level, orientation), b.band(level, orientation));
    return sum / (levels * kOrientations);
}

}  // namespace lumi::tools
