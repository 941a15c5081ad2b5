// SPDX-License-Identifier: MIT
#include "metrics/metrics.h"

#include <cmath>
#include <numeric>

namespace lumi::tools
{

namespace
{

// One axis of the Gaussian window, sum 1.
std::vector<double> gaussian_weights()
{
    constexpr double kSigma = 1.5;
    std::vector<double> weights;
    double sum = 0;
    for (int i = 0; i < kSsimWindow; ++i) {
        const double x = (i - kSsimWindow / 2) / kSigma;
        weights.push_back(std::exp(-x * x / 2));
        sum += weights.back();
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

Plane<double> product(const Plane<double>& a, const Plane<double>& b)
{
    Plane<double> result = a;
    for (size_t i = 0; i < result.values.size(); ++i) result.values[i] *= b.values[i];
    return result;
}

// Equation 13 of the paper for one window, from the local means of a, b, a², b² and ab.
double ssim_of_window(double mean_a, double mean_b, double square_a, double square_b, double cross)
{
    constexpr double kRange = 255, kC1 = (0.01 * kRange) * (0.01 * kRange), kC2 = (0.03 * kRange) * (0.03 * kRange);
    const double variances = square_a - mean_a * mean_a + square_b - mean_b * mean_b;
    const double covariance = cross - mean_a * mean_b;
    return (2 * mean_a * mean_b + kC1) * (2 * covariance + kC2) /
           ((mean_a * mean_a + mean_b * mean_b + kC1) * (variances + kC2));
}

// One value a window, at the window's corner.
Plane<double> ssim_map(const Picture& picture_a, const Picture& picture_b)
{
    check_precondition(same_size(picture_a, picture_b), "pictures of two sizes cannot be compared");
    check_precondition(picture_a.width_px >= kSsimWindow && picture_a.height_px >= kSsimWindow,
                       "the pictures are smaller than a window of SSIM");
    const std::vector<double> weights = gaussian_weights();
    const Plane<double> a = luma_plane(picture_a), b = luma_plane(picture_b);
    const Plane<double> mean_a = filter_valid(a, weights), mean_b = filter_valid(b, weights);
    const Plane<double> square_a = filter_valid(product(a, a), weights),
                        square_b = filter_valid(product(b, b), weights);
    Plane<double> map = filter_valid(product(a, b), weights);
    for (size_t i = 0; i < map.values.size(); ++i)
        map.values[i] =
            ssim_of_window(mean_a.values[i], mean_b.values[i], square_a.values[i], square_b.values[i], map.values[i]);
    return map;
}

}  // namespace

double ssim(const Picture& a, const Picture& b)
{
    const std::vector<double> values = ssim_map(a, b).values;
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double ssim(const Picture& a, const Picture& b, const Mask& mask)
{
    check_precondition(mask.width_px == a.width_px && mask.height_px == a.height_px,
                       "pictures of two sizes cannot be compared");
    const Plane<double> map = ssim_map(a, b);
    double sum = 0;
    int count = 0;
    for (int y = 0; y < map.height_px; ++y)
        for (int x = 0; x < map.width_px; ++x)
            if (mask.at(x + kSsimWindow / 2, y + kSsimWindow / 2) != 0) {
                sum += map.at(x, y);
                ++count;
            }
    return count == 0 ? 1 : sum / count;
}

}  // namespace lumi::tools
