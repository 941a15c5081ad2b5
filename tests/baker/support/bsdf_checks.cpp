// SPDX-License-Identifier: MIT
#include "support/bsdf_checks.h"

#include <catch2/catch.hpp>
#include <iomanip>
#include <sstream>

#include "math/sampler.h"
#include "math/warp.h"
#include "support/statistics.h"

namespace lumi::baker::testing
{
namespace
{

constexpr int kUpperHeights = 24, kUpperTurns = 48;

size_t upper_bin(const Vec3& wi)
{
    const float turn = std::atan2(wi.y, wi.x) / (2 * kPi);
    const int h = std::min(static_cast<int>(wi.z * kUpperHeights), kUpperHeights - 1);
    const int t = std::min(static_cast<int>((turn < 0 ? turn + 1 : turn) * kUpperTurns), kUpperTurns - 1);
    return static_cast<size_t>(h * kUpperTurns + t);
}

// The integral of pdf over each bin of the upper hemisphere, by the midpoint rule on a fine grid.
std::vector<double> expected_shares(const Bsdf& bsdf, const Vec3& wo, int steps)
{
    std::vector<double> shares(kUpperHeights * kUpperTurns);
    const double cell = 2 * static_cast<double>(kPi) / (kUpperHeights * steps) / (kUpperTurns * steps);
    for (int h = 0; h < kUpperHeights * steps; ++h) {
        for (int t = 0; t < kUpperTurns * steps; ++t) {
            const float z = (static_cast<float>(h) + 0.5f) / static_cast<float>(kUpperHeights * steps);
            const Vec3 wi = direction_at(z, (static_cast<float>(t) + 0.5f) / static_cast<float>(kUpperTurns * steps));
            shares[upper_bin(wi)] += static_cast<double>(bsdf.pdf(wo, wi)) * cell;
        }
    }
    return shares;
}

double sum(const std::vector<double>& v)
{
    double s = 0;
    for (const double x : v) s += x;
    return s;
}

}  // namespace

std::string short_text(float number)
{
    std::ostringstream out;
    out << std::fixed << std::setprecision(number < 0.1f ? 2 : 1) << number;
    return out.str();
}

std::vector<Vec3> views(float turns)
{
    std::vector<Vec3> all;
    for (const float z : {1.0f, 0.9f, 0.5f, 0.2f, 0.05f}) all.push_back(direction_at(z, turns));
    return all;
}

void check_density(const Named& named, const std::vector<Vec3>& viewers, int steps)
{
    constexpr uint32_t kSamples = 100000;
    for (const Vec3& wo : viewers) {
        INFO(named.name << ", viewer at height " << wo.z);
        std::vector<double> expected = expected_shares(named.bsdf, wo, steps);
        std::vector<double> counts(expected.size());
        uint32_t lost = 0;
        for (uint32_t k = 0; k < kSamples; ++k) {
            Sampler sampler(7, k, 0);
            const float u = sampler.next_1d();
            const std::optional<BsdfSample> s = named.bsdf.sample(wo, u, sampler.next_2d());
            lost += s ? 0u : 1u;
            if (s) ++counts[upper_bin(s->wi)];
        }
        const double share_lost = static_cast<double>(lost) / kSamples;
        // The grid's own error at the narrowest lobe is the larger part of the tolerance.
        CHECK(sum(expected) + share_lost == Approx(1).margin(0.01));
        expected.push_back(share_lost);
        counts.push_back(lost);
        const double total = sum(expected);
        for (double& e : expected) e *= kSamples / total;
        CHECK(chi2_score(counts, expected) < kSigmas);
    }
}

void check_weights(const Named& named, const std::vector<Vec3>& viewers)
{
    for (const Vec3& wo : viewers) {
        for (uint32_t k = 0; k < 200; ++k) {
            Sampler sampler(3, k, 1);
            const float u = sampler.next_1d();
            const std::optional<BsdfSample> s = named.bsdf.sample(wo, u, sampler.next_2d());
            if (!s || s->wi.z < 1e-3f) continue;
            INFO(named.name << ", viewer at height " << wo.z << ", sample " << k);
            // The half vector is computed anew, which binary32 limits for the narrowest lobe.
            const double tolerance = 0.02;
            CHECK(static_cast<double>(s->pdf) ==
                  Approx(static_cast<double>(named.bsdf.pdf(wo, s->wi))).epsilon(tolerance));
            const double value = static_cast<double>(named.bsdf.eval(wo, s->wi).g);
            CHECK(static_cast<double>(s->weight.g * s->pdf) == Approx(value).epsilon(tolerance));
        }
    }
}

void check_reciprocal(const Named& named)
{
    for (uint32_t k = 0; k < 500; ++k) {
        Sampler sampler(5, k, 2);
        const Vec2 u = sampler.next_2d();
        const Vec2 v = sampler.next_2d();
        const Vec3 a = direction_at(0.02f + 0.98f * u.x, u.y);
        const Vec3 b = direction_at(0.02f + 0.98f * v.x, v.y);
        INFO(named.name << ", pair " << k);
        const double ab = static_cast<double>(named.bsdf.eval(a, b).g / b.z);
        const double ba = static_cast<double>(named.bsdf.eval(b, a).g / a.z);
        CHECK(ab == Approx(ba).epsilon(1e-3).margin(1e-6));
    }
}

double checked_loss(const Named& named, const std::vector<Vec3>& viewers, double tolerance)
{
    constexpr uint32_t kSamples = 20000;
    double worst = 0;
    for (const Vec3& wo : viewers) {
        Mean albedo;
        for (uint32_t k = 0; k < kSamples; ++k) {
            Sampler sampler(11, k, 3);
            const float u = sampler.next_1d();
            const std::optional<BsdfSample> s = named.bsdf.sample(wo, u, sampler.next_2d());
            albedo.add(s ? static_cast<double>(s->weight.g) : 0.0);
        }
        INFO(named.name << ", viewer at height " << wo.z << ", albedo " << albedo.value() << " ± " << albedo.error());
        CHECK(albedo.value() <= 1 + kSigmas * albedo.error() + tolerance);
        worst = std::max(worst, 1 - albedo.value() - kSigmas * albedo.error());
    }
    return worst;
}

}  // namespace lumi::baker::testing
