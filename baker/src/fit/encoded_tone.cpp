// SPDX-License-Identifier: MIT
#include "fit/encoded_tone.h"

#include <algorithm>
#include <cmath>

#include "image/tone.h"

namespace lumi::baker
{
namespace
{

constexpr float kStepsPerLevel = 4;
constexpr int kSteps = 1600;  // up to 400 levels: what is far beyond white is cut when it is shown

double level_of(double linear)
{
    return 255 * srgb_encoded(linear);
}
double linear_of(double level)
{
    return srgb_linear(level / 255);
}
double slope_of(double linear)
{
    return 255 * (linear <= 0.0031308 ? 12.92 : 1.055 / 2.4 * std::pow(linear, 1 / 2.4 - 1));
}

using Matrix = std::array<std::array<float, 3>, 3>;

// A tone curve at the radiance that it takes to `linear`.
struct Tangent {
    Rgb at;
    Matrix slope;
};

Tangent identity_at(const Rgb& linear)
{
    return {linear, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
}

Tangent reinhard_at(const Rgb& linear)
{
    constexpr float kBrightest = 0.98f;
    const float dimmed = std::min(1.0f, kBrightest / std::max(luminance(linear), 1e-6f));
    const Rgb toned = linear * dimmed;
    const float rest = 1 - luminance(toned);  // 1/(1 + L)
    const Rgb at = toned * (1 / rest);
    const float weight[3] = {luminance({1, 0, 0}), luminance({0, 1, 0}), luminance({0, 0, 1})};
    const float values[3] = {at.r, at.g, at.b};
    Tangent t = {at, {}};
    for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k) t.slope[i][k] = (i == k ? rest : 0) - values[i] * weight[k] * rest * rest;
    return t;
}

// The inverse and the slope of tone.cpp's filmic curve (a x² + b x)/(c x² + d x + e).
Tangent filmic_at(const Rgb& linear)
{
    constexpr float kA = 2.51f, kB = 0.03f, kC = 2.43f, kD = 0.59f, kE = 0.14f, kBrightest = 0.99f;
    Tangent t = {};
    const float values[3] = {linear.r, linear.g, linear.b};
    float at[3];
    for (size_t k = 0; k < 3; ++k) {
        const float y = std::min(values[k], kBrightest);
        const float square = kA - kC * y, middle = kB - kD * y;
        at[k] = (-middle + std::sqrt(middle * middle + 4 * square * kE * y)) / (2 * square);
        const float x = at[k], below = (kC * x + kD) * x + kE;
        t.slope[k][k] = ((2 * kA * x + kB) * below - (kA * x + kB) * x * (2 * kC * x + kD)) / (below * below);
    }
    t.at = {at[0], at[1], at[2]};
    return t;
}

Tangent agx_at(const Rgb& linear)
{
    constexpr float kDarkest = 1e-5f, kBrightest = 0.98f;  // below, the curve is flat; above, light has no end
    const Rgb ends = agx::mixed(linear);
    const float values[3] = {ends.r, ends.g, ends.b};
    float light[3], slopes[3];
    for (size_t k = 0; k < 3; ++k) {
        light[k] = std::max(agx::inverse_curve(std::clamp(values[k], 0.0f, kBrightest)), kDarkest);
        slopes[k] = agx::slope(light[k]);
    }
    Tangent t = {agx::unmixed({light[0], light[1], light[2]}), {}};
    for (size_t column = 0; column < 3; ++column) {
        const Rgb in = agx::mixed({column == 0 ? 1.0f : 0, column == 1 ? 1.0f : 0, column == 2 ? 1.0f : 0});
        const Rgb out = agx::unmixed({slopes[0] * in.r, slopes[1] * in.g, slopes[2] * in.b});
        t.slope[0][column] = out.r;
        t.slope[1][column] = out.g;
        t.slope[2][column] = out.b;
    }
    return t;
}

Tangent tangent_at(ToneCurve curve, const Rgb& linear)
{
    switch (curve) {
        case ToneCurve::reinhard:
            return reinhard_at(linear);
        case ToneCurve::aces:
            return filmic_at(linear);
        case ToneCurve::agx:
            return agx_at(linear);
        case ToneCurve::srgb:
            break;
    }
    return identity_at(linear);
}

float determinant(const Matrix& m)
{
    const auto minor = [&](size_t a, size_t b) { return m[1][a] * m[2][b] - m[1][b] * m[2][a]; };
    return m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1);
}

}  // namespace

LevelColour ToneLine::operator()(const Rgb& radiance) const
{
    const Rgb d = radiance - at;
    LevelColour result;
    for (size_t k = 0; k < 3; ++k) result[k] = levels[k] + slope[k][0] * d.r + slope[k][1] * d.g + slope[k][2] * d.b;
    return result;
}

// Cramer's rule.
Rgb ToneLine::inverse(const LevelColour& wanted) const
{
    const float whole = determinant(slope);
    float d[3];
    for (size_t column = 0; column < 3; ++column) {
        Matrix m = slope;
        for (size_t row = 0; row < 3; ++row) m[row][column] = wanted[row] - levels[row];
        d[column] = determinant(m) / whole;
    }
    return at + Rgb{d[0], d[1], d[2]};
}

EncodedTone::EncodedTone(ToneCurve curve) : curve_(curve)
{
    for (int k = 0; k <= kSteps; ++k) {
        const double level = k / static_cast<double>(kStepsPerLevel), linear = linear_of(level);
        steps_.push_back({static_cast<float>(level), static_cast<float>(linear), static_cast<float>(slope_of(linear))});
    }
}

LevelColour EncodedTone::encoded(const Rgb& radiance) const
{
    const Rgb c = toned(curve_, radiance);
    const auto level = [](float v) { return static_cast<float>(level_of(static_cast<double>(v))); };
    return {level(c.r), level(c.g), level(c.b)};
}

const EncodedTone::Step& EncodedTone::step_at(float level) const
{
    const float place = std::clamp(level * kStepsPerLevel + 0.5f, 0.0f, static_cast<float>(kSteps));
    return steps_[static_cast<size_t>(place)];
}

ToneLine EncodedTone::line_at(const LevelColour& levels) const
{
    const Step *r = &step_at(levels[0]), *g = &step_at(levels[1]), *b = &step_at(levels[2]);
    const Tangent tone = tangent_at(curve_, {r->linear, g->linear, b->linear});
    if (curve_ == ToneCurve::srgb)
        return {tone.at, {r->level, g->level, b->level}, {{{r->slope, 0, 0}, {0, g->slope, 0}, {0, 0, b->slope}}}};
    // Curves that end below the asked levels: where they end.
    const Rgb reached = toned(curve_, tone.at);
    ToneLine line = {tone.at, encoded(tone.at), tone.slope};
    const float values[3] = {reached.r, reached.g, reached.b};
    for (size_t k = 0; k < 3; ++k) {
        const float slope = static_cast<float>(slope_of(static_cast<double>(values[k])));
        for (float& entry : line.slope[k]) entry *= slope;
    }
    return line;
}

ToneLine EncodedTone::invertible_line_at(const LevelColour& levels) const
{
    constexpr float kLeast = 0.25f;  // share of levels for a share of light
    constexpr float kMost = 64;      // times as steep; a strong colour's weak channel may have no rise of its own
    ToneLine line = line_at(levels);
    for (size_t k = 0; k < 3; ++k) {
        std::array<float, 3>& row = line.slope[k];
        const float rise = row[0] * line.at.r + row[1] * line.at.g + row[2] * line.at.b;
        const float steeper = kLeast * line.levels[k] / rise;
        if (rise > 0 && steeper > 1)
            for (float& entry : row) entry *= std::min(steeper, kMost);
    }
    return line;
}

}  // namespace lumi::baker
