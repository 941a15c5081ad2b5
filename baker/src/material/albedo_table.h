// SPDX-License-Identifier: MIT
// How much of the light that arrives from one direction a rough surface sends on in all, as a function of the
// direction's cosine.
#pragma once

#include <array>
#include <cstddef>

#include "material/microfacet.h"
#include "math/vec3.h"
#include "util/fuzzed.h"

namespace lumi::baker
{

// A cosine just above 0 stands in for the horizon itself, where the facets' functions have no value.
inline constexpr float kLeastCosine = 1e-3f;

class AlbedoTable
{
public:
    AlbedoTable() = default;
    // albedo_at: from a cosine in [kLeastCosine, 1] to a value in [0, 1].
    template <class Function>
    explicit AlbedoTable(const Function& albedo_at)
    {
        for (size_t k = 0; k <= kSteps; ++k)
            table_[k] = albedo_at(std::max(static_cast<float>(k) / kSteps, kLeastCosine));
        integrate();
    }

    float at(float cosine) const
    {
        const float place = std::clamp(cosine, 0.0f, 1.0f) * kSteps;
        const size_t k = std::min(static_cast<size_t>(place), kSteps - 1);
        const float f = place - static_cast<float>(k);
        return table_[k] * (1 - f) + table_[k + 1] * f;
    }
    float at(const Vec3& direction) const { return at(direction.z); }
    // Mean over a hemisphere of diffuse light.
    float mean() const { return mean_; }

private:
    static constexpr size_t kSteps = kIsFuzzed ? 4 : 64;

    // Returns the exact integral of 2·cosine·albedo over each step of the interpolated table.
    void integrate()
    {
        constexpr float kStep = 1.0f / kSteps;
        for (size_t k = 0; k < kSteps; ++k) {
            const float a = static_cast<float>(k) * kStep, b = a + kStep;
            mean_ += kStep / 3 * (table_[k] * (2 * a + b) + table_[k + 1] * (a + 2 * b));
        }
    }

    float mean_ = 0;
    std::array<float, kSteps + 1> table_{};
};

// An AlbedoTable of surfaces whose facets spread differently along x and along y.

class AnisotropicAlbedo
{
public:
    // albedo_at: from a direction with a z in [kLeastCosine, 1] to a value in [0, 1].
    template <class Function>
    AnisotropicAlbedo(const Anisotropic& spread, const Function& albedo_at)
        : least_(std::min(spread.alpha_x, spread.alpha_y)),
          range_(std::abs(spread.alpha_x - spread.alpha_y)),
          along_x_(spread.alpha_x > spread.alpha_y)
    {
        for (size_t k = 0; k <= kSteps; ++k) {
            const Vec2 towards = azimuth(static_cast<float>(k) / kSteps);
            tables_[k] = AlbedoTable([&](float cosine) {
                const float sine = std::sqrt(1 - cosine * cosine);
                return albedo_at(Vec3{sine * towards.x, sine * towards.y, cosine});
            });
        }
        integrate();
    }

    float at(const Vec3& direction) const
    {
        const Step s = step(direction);
        return tables_[s.k].at(direction.z) * (1 - s.f) + tables_[s.k + 1].at(direction.z) * s.f;
    }
    // Mean over a hemisphere of diffuse light.
    float mean() const { return mean_; }

private:
    static constexpr size_t kSteps = kIsFuzzed ? 2 : 8;

    struct Step {
        size_t k;
        float f;
    };

    // Steps are equal in the width that the facets have along the direction, on which the albedo depends smoothly.
    Step step(const Vec3& d) const
    {
        const float across2 = d.x * d.x + d.y * d.y;
        if (!(across2 > 0) || !(range_ > 0)) return {0, 0};
        const float wide2 = (along_x_ ? d.x * d.x : d.y * d.y) / across2;
        const float width = std::sqrt(least_ * least_ + (2 * least_ + range_) * range_ * wide2);
        const float place = std::clamp((width - least_) / range_, 0.0f, 1.0f) * kSteps;
        const size_t k = std::min(static_cast<size_t>(place), kSteps - 1);
        return {k, place - static_cast<float>(k)};
    }

    // The unit vector in the surface along which the width is least_ + range_·share.
    Vec2 azimuth(float share) const
    {
        const float wide2 = std::min(share * (2 * least_ + range_ * share) / (2 * least_ + range_), 1.0f);
        const float wide = std::sqrt(wide2), narrow = std::sqrt(1 - wide2);
        return along_x_ ? Vec2{wide, narrow} : Vec2{narrow, wide};
    }

    // The mean over all azimuths, a quarter of which says it all, by the midpoint rule.
    void integrate()
    {
        constexpr int kMidpoints = kIsFuzzed ? 8 : 256;
        for (int m = 0; m < kMidpoints; ++m) {
            const Step s = step(direction_at(0, (static_cast<float>(m) + 0.5f) / (4 * kMidpoints)));
            mean_ += (tables_[s.k].mean() * (1 - s.f) + tables_[s.k + 1].mean() * s.f) / kMidpoints;
        }
    }

    float least_, range_;
    bool along_x_;
    float mean_ = 0;
    std::array<AlbedoTable, kSteps + 1> tables_;
};

}  // namespace lumi::baker
