// SPDX-License-Identifier: MIT
#include "metrics/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "math/pi.h"

namespace lumi::tools
{

namespace
{

using Values = std::vector<double>;
using Colour = std::array<double, 3>;

// Colour spaces, section 3 and appendix A of the paper: linear RGB (Rec. 709, D65) over XYZ.

double linear_light(double v)
{
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

Colour xyz_of(const Colour& c)
{
    return {(10135552 * c[0] + 8788810 * c[1] + 4435075 * c[2]) / 24577794.0,
            (2613072 * c[0] + 8788810 * c[1] + 887015 * c[2]) / 12288897.0,
            (1425312 * c[0] + 8788810 * c[1] + 70074185 * c[2]) / 73733382.0};
}

Colour rgb_of(const Colour& c)
{
    return {3.241003275 * c[0] - 1.537398934 * c[1] - 0.498615861 * c[2],
            -0.969224334 * c[0] + 1.875930071 * c[1] + 0.041554224 * c[2],
            0.055639423 * c[0] - 0.204011202 * c[1] + 1.057148933 * c[2]};
}

const Colour kWhite = xyz_of({1, 1, 1});

// Linear in light, so filters may work on it: the achromatic, the red-green and the blue-yellow channel.
Colour ycc_of(const Colour& rgb)
{
    const Colour c = xyz_of(rgb);
    const double x = c[0] / kWhite[0], y = c[1] / kWhite[1], z = c[2] / kWhite[2];
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Colour rgb_of_ycc(const Colour& c)
{
    const double y = (c[0] + 16) / 116;
    return rgb_of({kWhite[0] * (c[1] / 500 + y), kWhite[1] * y, kWhite[2] * (y - c[2] / 200)});
}

double lab_root(double v)
{
    constexpr double kDelta = 6.0 / 29;
    return v > kDelta * kDelta * kDelta ? std::cbrt(v) : v / (3 * kDelta * kDelta) + 4.0 / 29;
}

// L*a*b* with the Hunt effect: colours differ less where it is dark.
Colour hunt_lab_of(const Colour& rgb)
{
    const Colour c = xyz_of(rgb);
    const double x = lab_root(c[0] / kWhite[0]), y = lab_root(c[1] / kWhite[1]), z = lab_root(c[2] / kWhite[2]);
    const double lightness = 116 * y - 16;
    return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

double hyab(const Colour& a, const Colour& b)
{
    return std::fabs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

// One axis of a filter over -radius .. radius.
template <class Function>
Values sampled(int radius, const Function& f)
{
    Values values;
    for (int i = -radius; i <= radius; ++i) values.push_back(f(i));
    return values;
}

Plane<double> filtered(const Plane<double>& plane, const Values& along_x, const Values& along_y)
{
    const int radius = static_cast<int>(along_x.size() / 2);
    const int right = plane.width_px - 1, bottom = plane.height_px - 1;
    Plane<double> rows(plane.width_px, plane.height_px), result(plane.width_px, plane.height_px);
    for (int y = 0; y <= bottom; ++y)
        for (int x = 0; x <= right; ++x)
            for (int i = -radius; i <= radius; ++i)
                rows.at(x, y) += along_x[static_cast<size_t>(i + radius)] * plane.at(std::clamp(x + i, 0, right), y);
    for (int y = 0; y <= bottom; ++y)
        for (int i = -radius; i <= radius; ++i)
            for (int x = 0; x <= right; ++x)
                result.at(x, y) += along_y[static_cast<size_t>(i + radius)] * rows.at(x, std::clamp(y + i, 0, bottom));
    return result;
}

// Contrast sensitivity of a channel in space: a1·sqrt(π/b1)·exp(-π²x²/b1) + the same with a2, b2; x in degrees.
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> kSensitivity = {{
    {1, 0.0047, 0, 1e-5},
    {1, 0.0053, 0, 1e-5},
    {34.1, 0.04, 13.5, 0.025},
}};
constexpr double kWidest = 0.04;

Plane<double> seen(const Plane<double>& channel, const Sensitivity& s, double pixels_per_degree)
{
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * pixels_per_degree));
    Plane<double> result(channel.width_px, channel.height_px);
    double whole = 0;
    for (const auto& [a, b] : {std::pair(s.a1, s.b1), std::pair(s.a2, s.b2)}) {
        if (a == 0) continue;
        const Values bell = sampled(radius, [&, b = b](int i) {
            const double x = i / pixels_per_degree;
            return std::exp(-kPi * kPi * x * x / b);
        });
        const double height = a * std::sqrt(kPi / b), area = std::accumulate(bell.begin(), bell.end(), 0.0);
        const Plane<double> part = filtered(channel, bell, bell);
        for (size_t i = 0; i < part.values.size(); ++i) result.values[i] += height * part.values[i];
        whole += height * area * area;
    }
    for (double& value : result.values) value /= whole;
    return result;
}

struct Channels {
    std::array<Plane<double>, 3> ycc;
};

Channels channels_of(const Picture& picture)
{
    Channels channels;
    channels.ycc.fill(Plane<double>(picture.width_px, picture.height_px));
    for (size_t i = 0; i < channels.ycc[0].values.size(); ++i) {
        Colour rgb;
        for (size_t k = 0; k < 3; ++k) rgb[k] = linear_light(picture.rgb[3 * i + k] / 255.0);
        const Colour c = ycc_of(rgb);
        for (size_t k = 0; k < 3; ++k) channels.ycc[k].values[i] = c[k];
    }
    return channels;
}

// Follows what the eye makes of the colours, pixel by pixel.
std::vector<Colour> seen_colours(const Channels& channels, double pixels_per_degree)
{
    std::array<Plane<double>, 3> blurred;
    for (size_t k = 0; k < 3; ++k) blurred[k] = seen(channels.ycc[k], kSensitivity[k], pixels_per_degree);
    std::vector<Colour> colours(blurred[0].values.size());
    for (size_t i = 0; i < colours.size(); ++i) {
        Colour rgb = rgb_of_ycc({blurred[0].values[i], blurred[1].values[i], blurred[2].values[i]});
        for (double& c : rgb) c = std::clamp(c, 0.0, 1.0);
        colours[i] = hunt_lab_of(rgb);
    }
    return colours;
}

// Equation 9: most of the range for differences below kKnee of the largest, that of green and blue.
double colour_error(const Colour& a, const Colour& b)
{
    constexpr double kPower = 0.7, kKnee = 0.4, kAtKnee = 0.95;
    static const double largest = std::pow(hyab(hunt_lab_of({0, 1, 0}), hunt_lab_of({0, 0, 1})), kPower);
    const double error = std::pow(hyab(a, b), kPower), knee = kKnee * largest;
    return error < knee ? error * kAtKnee / knee : kAtKnee + (error - knee) / (largest - knee) * (1 - kAtKnee);
}

// Positive and negative weights of across(x)·along(y) each sum to one.
void balance(Values& across, const Values& along)
{
    double positive = 0, negative = 0;
    for (const double v : across) (v > 0 ? positive : negative) += std::fabs(v);
    const double rest = std::accumulate(along.begin(), along.end(), 0.0);
    for (double& v : across) v /= (v > 0 ? positive : negative) * rest;
}

struct Features {
    Values edges, points;  // strength a pixel
};

Values strength(const Plane<double>& light, const Values& across, const Values& along)
{
    const Plane<double> x = filtered(light, across, along), y = filtered(light, along, across);
    Values result(x.values.size());
    for (size_t i = 0; i < result.size(); ++i) result[i] = std::hypot(x.values[i], y.values[i]);
    return result;
}

// Section 3.2: first and second derivatives of Gaussians as wide as an edge that the eye resolves.
Features features_of(const Channels& channels, double pixels_per_degree)
{
    constexpr double kFeatureDegrees = 0.082;
    const double sigma = 0.5 * kFeatureDegrees * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const auto bell = [sigma](int i) { return std::exp(-i * i / (2 * sigma * sigma)); };
    const Values along = sampled(radius, bell);
    Values edge = sampled(
        radius, [&](int i) { return -i * bell(i); });
    Values point = sampled(radius, [&](int i) { return (i * i / (sigma * sigma) - 1) * bell(i); });
    balance(edge, along);
    balance(point, along);
    Plane<double> light = channels.ycc[0];
    for (double& v : light.values) v = (v + 16) / 116;
    return {strength(light, edge, along), strength(light, point, along)};
}

}  // namespace

Plane<double> flip_map(const Picture& reference, const Picture& test, double pixels_per_degree)
{
    check_precondition(same_size(reference, test) && !reference.rgb.empty() && pixels_per_degree > 0,
                       "pictures of two sizes cannot be compared");
    const Channels a = channels_of(reference), b = channels_of(test);
    const std::vector<Colour> colour_a = seen_colours(a, pixels_per_degree),
                              colour_b = seen_colours(b, pixels_per_degree);
    const Features feature_a = features_of(a, pixels_per_degree), feature_b = features_of(b, pixels_per_degree);
    Plane<double> map(reference.width_px, reference.height_px);
    for (size_t i = 0; i < map.values.size(); ++i) {
        const double edge = std::fabs(feature_a.edges[i] - feature_b.edges[i]);
        const double point = std::fabs(feature_a.points[i] - feature_b.points[i]);
        const double feature = std::sqrt(std::min(1.0, std::max(edge, point) / std::sqrt(2.0)));
        map.values[i] = std::pow(colour_error(colour_a[i], colour_b[i]), 1 - feature);
    }
    return map;
}

double flip(const Picture& reference, const Picture& test, double pixels_per_degree)
{
    const Values errors = flip_map(reference, test, pixels_per_degree).values;
    return std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
}

}  // namespace lumi::tools
