// SPDX-License-Identifier: MIT
#include "material/sheen.h"

#include "material/lobes.h"
#include "util/fuzzed.h"

namespace lumi::baker
{
namespace
{

// ∫ max(0, a + b·cos φ) over a whole turn, b >= 0.
double positive_part(double a, double b)
{
    constexpr double kPiDouble = 3.14159265358979323846;
    if (a >= b) return 2 * kPiDouble * a;
    return 2 * (a * std::acos(std::max(-a / b, -1.0)) + std::sqrt(std::max(0.0, b * b - a * a)));
}

// The area of facets that a direction sees, Σ density·<w·half>, by the midpoint rule over their sine.
template <class Density>
float seen_area(float cosine, const Density& density)
{
    constexpr int kMidpoints = kIsFuzzed ? 16 : 1024;
    const double c = static_cast<double>(cosine), s = std::sqrt(1 - c * c);
    double sum = 0;
    for (int k = 0; k < kMidpoints; ++k) {
        // The sine is 1 - x², which takes the infinite slope out of the horizon: dω = 2x·sine/cosine dx dφ.
        const double x = (k + 0.5) / kMidpoints, sine = 1 - x * x, slope = std::sqrt(2 - x * x);
        const double height = x * slope;
        sum += static_cast<double>(density(static_cast<float>(sine))) * positive_part(c * height, s * sine) * 2 * sine /
               slope;
    }
    return static_cast<float>(sum / kMidpoints);
}

// The share of light that white fibres send back, by a Fibonacci lattice of uniform directions.
template <class Value>
float albedo_at(float cosine, const Value& value)
{
    constexpr int kSamples = kIsFuzzed ? 13 : 4181, kStep = kIsFuzzed ? 8 : 2584;
    const Vec3 wo = direction_at(cosine, 0);
    float sum = 0;
    for (int k = 0; k < kSamples; ++k) {
        const float z = (static_cast<float>(k) + 0.5f) / kSamples;
        sum += value(wo, direction_at(z, (static_cast<float>(k * kStep % kSamples) + 0.5f) / kSamples));
    }
    return std::min(2 * kPi * sum / kSamples, 1.0f);
}

}  // namespace

SheenTable::SheenTable(float roughness)
    : roughness_(roughness), profile_([roughness](float sine) {
          return static_cast<float>(std::pow(static_cast<double>(sine), 1 / static_cast<double>(roughness)));
      })
{
    const auto facets = [this](float sine) { return profile_.at(sine) / (kPi * profile_.mean()); };
    seen_ = AlbedoTable([&](float cosine) { return seen_area(cosine, facets); });
    albedo_ = AlbedoTable([this](float cosine) {
        return albedo_at(cosine, [this](const Vec3& wo, const Vec3& wi) { return value(wo, wi); });
    });
}

float SheenTable::density(const Vec3& half) const
{
    // The table's mean, ∫ 2·sine·profile, makes the facets cover the surface once.
    return profile_.at(std::sqrt(std::min(half.x * half.x + half.y * half.y, 1.0f))) / (kPi * profile_.mean());
}

float SheenTable::value(const Vec3& wo, const Vec3& wi) const
{
    // density·shadowing/(4·cos θo·cos θi)·cos θi, with Smith's 1 + Λ = seen/cosine: no quotient by either cosine is
    // left.
    const float visible = seen_.at(wo) * wi.z + seen_.at(wi) * wo.z - wo.z * wi.z;
    return density(normalized(wo + wi)) * wi.z / (4 * std::max(visible, 1e-7f));
}

}  // namespace lumi::baker
