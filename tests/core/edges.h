// SPDX-License-Identifier: MIT
// Random views at the edges of what a camera and an image may be.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "views.h"

namespace lumi::test
{

// A view, and the window of its image that is drawn.
struct Edge {
    Pose pose;
    Image image;
    int32_t x, y, width, height;
};

class Edges
{
public:
    // Windows are `window_px` high and about twice as wide.
    Edges(uint32_t seed, int32_t window_px) : random_(seed), window_px_(window_px) {}

    // The sphere's rim, its middle or a pole in view; from the axes and from anywhere; images of odd and of the
    // largest sizes, lenses shifted as far as they may be.
    Edge next(double distance, double fov)
    {
        const Vec3 eye = distance * direction();
        const Vec3 target = uniform(0, 1) < 0.5 ? Vec3{0, 0, 0} : rim_of(eye, distance);
        const bool large = uniform(0, 1) < 0.25;
        const int32_t width = large ? kMaxImageSide : 2 * window_px_ + 1;
        const int32_t height = large ? kMaxImageSide - 1 : window_px_;
        Edge edge{look_at(eye, target, uniform(0, 360)), {width, height, degrees(fov)}, 0, 0, 0, 0};
        if (uniform(0, 1) < 0.25) {
            edge.image.shift_x_q8 = (uniform(0, 1) < 0.5 ? -256 : 256) * width;
            edge.image.shift_y_q8 = (uniform(0, 1) < 0.5 ? -256 : 256) * height;
        }
        edge.width = std::min(width, 2 * window_px_ + 1);
        edge.height = std::min(height, window_px_);
        edge.x = large ? static_cast<int32_t>(uniform(0, width - edge.width)) : 0;
        edge.y = large ? static_cast<int32_t>(uniform(0, height - edge.height)) : 0;
        return edge;
    }

    double uniform(double low, double high)
    {
        return low + (high - low) * std::generate_canonical<double, 32>(random_);
    }

private:
    // An axis, or anywhere.
    Vec3 direction()
    {
        const Vec3 axes[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}};
        const size_t choice = static_cast<size_t>(uniform(0, 10));
        if (choice < 5) return axes[choice];
        const double z = uniform(-1, 1);
        const double angle = uniform(0, 2 * twin::kPi);
        const double r = std::sqrt(1 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

    // Where a ray from the eye touches the sphere.
    Vec3 rim_of(const Vec3& eye, double distance)
    {
        const Vec3 up = twin::normalised(eye);
        const Vec3 side = twin::normalised(cross(up, std::fabs(up.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
        const double s = 1 / (distance * 1.0001);
        return s * up + std::sqrt(1 - s * s) * side;
    }

    std::minstd_rand random_;
    int32_t window_px_;
};

}  // namespace lumi::test
