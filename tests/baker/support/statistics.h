// SPDX-License-Identifier: MIT
// Statistics for tests with fixed seeds: a failure is a fault, not bad luck.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace lumi::baker::testing
{

// Two-sided bounds of this many standard errors are crossed once in 15,000 honest trials.
inline constexpr double kSigmas = 4;

class Mean
{
public:
    void add(double x)
    {
        ++count_;
        const double delta = x - mean_;
        mean_ += delta / static_cast<double>(count_);
        squares_ += delta * (x - mean_);
    }
    double value() const { return mean_; }
    double error() const
    {
        const double n = static_cast<double>(count_);
        return std::sqrt(squares_ / (n - 1) / n);
    }

private:
    size_t count_ = 0;
    double mean_ = 0, squares_ = 0;
};

// Pearson's test as a standard score (Wilson & Hilferty, 1931): above kSigmas the counts do not follow `expected`. Bins
// that expect fewer than 5 are pooled.
inline double chi2_score(const std::vector<double>& counts, const std::vector<double>& expected)
{
    constexpr double kLeastExpected = 5;
    double chi2 = 0, pooled_count = 0, pooled_expected = 0;
    int freedom = -1;
    const auto take = [&](double count, double expect) {
        chi2 += (count - expect) * (count - expect) / expect;
        ++freedom;
    };
    for (size_t k = 0; k < counts.size(); ++k) {
        if (expected[k] >= kLeastExpected) {
            take(counts[k], expected[k]);
        } else {
            pooled_count += counts[k];
            pooled_expected += expected[k];
        }
    }
    if (pooled_expected > 0) take(pooled_count, std::max(pooled_expected, 1.0));
    const double k = freedom;
    const double spread = 2 / (9 * k);
    return (std::cbrt(chi2 / k) - (1 - spread)) / std::sqrt(spread);
}

}  // namespace lumi::baker::testing
