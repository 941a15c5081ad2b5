// SPDX-License-Identifier: MIT
// Directions over the sphere at which maps of a lattice are tested: dense where maps meet.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "twin.h"

namespace lumi::test
{

// Directions over the sphere, dense at the poles, on the seam of the longitude, at lattice points and between them.
class Directions
{
public:
    explicit Directions(uint32_t n) : n_(n), random_(n) {}

    twin::Vec3 next(uint32_t k)
    {
        switch (k % 6) {
            case 0:
                return near_pole(1);
            case 1:
                return near_pole(-1);
            case 2:
                return on_seam();
            case 3:
                return between_points();
            default:
                return anywhere();
        }
    }

    double uniform() { return std::generate_canonical<double, 32>(random_); }

    static twin::Vec3 at(double z, double turns)
    {
        const double radius = std::sqrt(std::fmax(0.0, 1 - z * z));
        return {radius * std::cos(2 * twin::kPi * turns), radius * std::sin(2 * twin::kPi * turns), z};
    }

    twin::Vec3 anywhere() { return at(2 * uniform() - 1, uniform()); }

    // On a circle of this real-valued index around either pole.
    twin::Vec3 on_ring(double height)
    {
        const double z = std::fmax(-1.0, 1 - (2 * height + 1) / n_);
        return at(uniform() < 0.5 ? z : -z, uniform());
    }

private:
    twin::Vec3 near_pole(double side) { return at(side * (1 - std::fmin(2.0, uniform() * 80 / n_)), uniform()); }
    twin::Vec3 on_seam() { return at(2 * uniform() - 1, (uniform() - 0.5) * 1e-8); }

    twin::Vec3 between_points()
    {
        const auto i = static_cast<uint32_t>(uniform() * n_);
        const twin::Vec3 a = twin::point(n_, i);
        const twin::Vec3 b = anywhere();
        const twin::Vec3 mixed = a + (twin::spacing(n_) * uniform()) * b;
        return twin::length(mixed) > 0 ? twin::normalised(mixed) : a;
    }

    uint32_t n_;
    std::mt19937 random_;
};

}  // namespace lumi::test
