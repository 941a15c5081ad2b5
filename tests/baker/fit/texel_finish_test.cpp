// SPDX-License-Identifier: MIT
#include "fit/texel_finish.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "math/sampler.h"

namespace lumi::baker::testing
{
namespace
{

constexpr uint32_t kSide = 24;

// Texels that each met so many paths, of which one in `rarity` is lit: a lamp behind a small hole.
std::vector<TexelLight> rare_light(const EncodedTone& tone, uint32_t paths, uint32_t rarity, float bright)
{
    Sampler sampler(3, 0, 0);
    const float mean = bright / static_cast<float>(rarity);
    const ToneLine line = tone.line_at(tone.encoded({mean, mean, mean}));
    std::vector<TexelLight> result;
    for (uint32_t t = 0; t < kSide * kSide; ++t) {
        sampler.start(t);
        double sum = 0, squares = 0;
        for (uint32_t k = 0; k < paths; ++k) {
            const float value = sampler.next_1d() * static_cast<float>(rarity) < 1 ? bright : 0.0f;
            const double levels = static_cast<double>(line({value, value, value})[1]);
            sum += levels;
            squares += (levels - static_cast<double>(line.levels[1])) * (levels - static_cast<double>(line.levels[1]));
        }
        const auto target = static_cast<float>(sum / paths);
        const float mean_light = line.inverse({target, target, target}).g;
        result.push_back({line, {target, target, target}, {mean_light, mean_light, mean_light}, {}, squares, paths});
    }
    return result;
}

float mean_light(const EncodedTone& tone, const std::vector<LevelColour>& texels)
{
    float sum = 0;
    for (const LevelColour& t : texels) {
        const ToneLine line = tone.line_at(t);
        sum += line.inverse(t).g;
    }
    return sum / static_cast<float>(texels.size());
}

}  // namespace

TEST_CASE("light that few paths find is not darker for it", "[fit]")
{
    const EncodedTone tone(ToneCurve::srgb);
    for (const uint32_t rarity : {10u, 100u}) {
        const std::vector<TexelLight> light = rare_light(tone, 60, rarity, 2);
        float summed = 0;
        for (const TexelLight& t : light) summed += t.line.inverse(t.target).g / static_cast<float>(light.size());
        CHECK(mean_light(tone, finished(tone, light, kSide)) == Approx(summed).epsilon(0.03));
    }
}

TEST_CASE("expectations that are wrong by noise do not make light brighter", "[fit]")
{
    const EncodedTone tone(ToneCurve::srgb);
    const float light = tone.line_at({120, 120, 120}).at.g;
    const ToneLine middle = tone.line_at({120, 120, 120});
    TexelLight texel = {middle, {}, {light, light, light}, {}, 0, 64};
    for (const float off : {-50.0f, +50.0f}) {  // half of the views each
        const LevelColour summed = tone.line_at({120 + off, 120 + off, 120 + off})({light, light, light});
        for (size_t c = 0; c < 3; ++c) texel.target[c] += summed[c] / 2;
    }
    REQUIRE(texel.target[1] > 125);  // tangents lie above the curve
    CHECK(finished(tone, {texel}, 1).front()[1] == Approx(120).margin(0.1));
}

TEST_CASE("views that differ keep the mean of what is shown", "[fit]")
{
    const EncodedTone tone(ToneCurve::srgb);
    const float dark = tone.line_at({40, 40, 40}).at.g, bright = tone.line_at({200, 200, 200}).at.g;
    const float mean = (dark + bright) / 2;
    const LevelColour shown = {120, 120, 120};
    const TexelLight texel = {tone.line_at(shown), shown, {mean, mean, mean}, {}, 0, 64};
    REQUIRE(tone.encoded(texel.light)[1] > 140);
    CHECK(finished(tone, {texel}, 1).front()[1] == Approx(120).margin(0.1));
}

TEST_CASE("what view tables add stays out of a texel", "[fit]")
{
    const EncodedTone tone(ToneCurve::srgb);
    std::vector<TexelLight> light = rare_light(tone, 60, 1, 0.5f);
    for (TexelLight& t : light) t.tables = {20, 0, -5};
    const LevelColour first = finished(tone, light, kSide).front();
    CHECK(first[0] == Approx(light.front().target[0] - 20).margin(0.2));
    CHECK(first[2] == Approx(light.front().target[2] + 5).margin(0.2));
}

TEST_CASE("black and white texels have finite levels by every tone curve", "[fit]")
{
    for (const ToneCurve curve : {ToneCurve::srgb, ToneCurve::reinhard, ToneCurve::aces, ToneCurve::agx}) {
        const EncodedTone tone(curve);
        for (const float level : {0.0f, 255.0f}) {
            for (const float other : {0.0f, 255.0f}) {
                const LevelColour shown = {level, other, other};
                const ToneLine line = tone.line_at(shown);
                const TexelLight texel = {line, shown, line.at, {}, 0, 4};
                const TexelLight lit = {line, shown, {1e6f, 0, 1e6f}, {}, 1e9, 1};
                for (const LevelColour& c : finished(tone, {texel, lit, texel, lit}, 2))
                    for (const float v : c) CHECK(std::isfinite(v));
            }
        }
    }
}

// Near white some curves are so flat that a few levels along a tangent may be any light, also less than none.
TEST_CASE("texels that a share of views sees as white have no other colour for it", "[fit]")
{
    const Rgb grey = {0.45f, 0.45f, 0.45f}, bright = {20, 20, 20};
    for (const ToneCurve curve : {ToneCurve::srgb, ToneCurve::reinhard, ToneCurve::aces, ToneCurve::agx}) {
        const EncodedTone tone(curve);
        const LevelColour shown = tone.encoded(grey);
        Sampler sampler(5, 0, 0);
        std::vector<TexelLight> light;
        for (uint32_t t = 0; t < kSide * kSide; ++t) {
            sampler.start(t);
            const float share = 0.5f + 0.4f * sampler.next_1d();
            LevelColour expected, target;
            for (size_t c = 0; c < 3; ++c) {
                const float beyond = 260 + 80 * sampler.next_1d();
                expected[c] = std::min(255.0f, share * beyond + (1 - share) * shown[c]);
                target[c] = share * 255 + (1 - share) * shown[c];
            }
            const Rgb mean = bright * share + grey * (1 - share);
            light.push_back({tone.line_at(expected), target, mean, {}, 100, 20});
        }
        for (const LevelColour& c : finished(tone, light, kSide))
            for (const float v : c) CHECK(v == Approx(230).margin(35));
    }
}

TEST_CASE("a rectangle that no path met keeps its texels", "[fit]")
{
    const EncodedTone tone(ToneCurve::srgb);
    const LevelColour kept = {90, 80, 70};
    const TexelLight texel = {tone.line_at({0, 0, 0}), kept, {}, {}, 0, 0};
    for (const LevelColour& c : finished(tone, {texel, texel}, 2)) CHECK(c == kept);
}

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
