// SPDX-License-Identifier: MIT
// How much of the light that arrives from one direction a rough surface sends on in all, as a function of the
// direction's cosine.
#pragma once

#include <array>
#include <cstddef>

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

    // The exact integral of 2·cosine·albedo over each step of the interpolated table.
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

}  // namespace lumi::baker
