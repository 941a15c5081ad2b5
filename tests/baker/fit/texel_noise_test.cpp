// SPDX-License-Identifier: MIT
#include "fit/texel_noise.h"

#include <catch2/catch.hpp>

#include "math/sampler.h"

namespace lumi::baker::testing
{
namespace
{

constexpr uint32_t kWidth = 24;
constexpr double kVariance = 16;

// A dark and a bright half; every texel off by noise of kVariance.
struct Noisy {
    std::vector<LevelColour> truth, texels;

    explicit Noisy(float step)
    {
        Sampler sampler(7, 0, 0);
        for (uint32_t k = 0; k < kWidth * kWidth; ++k) {
            sampler.start(k);
            const float level = k % kWidth < kWidth / 2 ? 100.0f : 100.0f + step;
            truth.push_back({level, level, level});
            LevelColour texel = truth.back();
            for (float& channel : texel) {
                // The sum of 12 is close to normal.
                for (int m = 0; m < 12; ++m) channel += 4 * (sampler.next_1d() - 0.5f);
            }
            texels.push_back(texel);
        }
    }

    double error2() const
    {
        double sum = 0;
        for (size_t k = 0; k < truth.size(); ++k) {
            for (size_t c = 0; c < 3; ++c) {
                const double off = static_cast<double>(texels[k][c] - truth[k][c]);
                sum += off * off / (3.0 * static_cast<double>(truth.size()));
            }
        }
        return sum;
    }
};

}  // namespace

TEST_CASE("noise leaves what is smooth")
{
    Noisy flat(0);
    CHECK(flat.error2() == Approx(kVariance).epsilon(0.1));
    smooth_noise(flat.texels.data(), std::vector<double>(kWidth * kWidth, kVariance), kWidth);
    CHECK(flat.error2() < kVariance / 5);
}

TEST_CASE("edges that stand out from noise stay")
{
    Noisy edge(60);
    smooth_noise(edge.texels.data(), std::vector<double>(kWidth * kWidth, kVariance), kWidth);
    CHECK(edge.error2() < kVariance / 2);
    const size_t middle = kWidth * kWidth / 2 + kWidth / 2;
    CHECK(edge.texels[middle][0] - edge.texels[middle - 1][0] > 45);
}

TEST_CASE("texels that are known exactly stay as they are")
{
    Noisy known(60);
    const std::vector<LevelColour> before = known.texels;
    smooth_noise(known.texels.data(), std::vector<double>(kWidth * kWidth, 0), kWidth);
    for (size_t k = 0; k < before.size(); ++k) CHECK(std::abs(known.texels[k][1] - before[k][1]) < 0.1f);
}

TEST_CASE("texels that no path met are filled from around")
{
    std::vector<LevelColour> texels(kWidth * kWidth, LevelColour{80, 90, 100});
    std::vector<double> variances(kWidth * kWidth, kVariance);
    for (uint32_t k = 0; k < 5; ++k) {
        texels[5 * kWidth + k] = {0, 0, 0};
        variances[5 * kWidth + k] = -1;
    }
    smooth_noise(texels.data(), variances, kWidth);
    for (uint32_t k = 0; k < 5; ++k) CHECK(texels[5 * kWidth + k][2] == Approx(100).margin(0.5));
}

TEST_CASE("a rectangle that no path met stays")
{
    std::vector<LevelColour> texels(12, LevelColour{1, 2, 3});
    smooth_noise(texels.data(), std::vector<double>(12, -1), 4);
    for (const LevelColour& texel : texels) CHECK((texel == LevelColour{1, 2, 3}));
}

}  // namespace lumi::baker::testing
