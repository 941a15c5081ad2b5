// SPDX-License-Identifier: MIT
#include "fit/texel_finish.h"

#include <algorithm>
#include <cstddef>

#include "fit/texel_noise.h"

namespace lumi::baker
{
namespace
{

constexpr int kAroundReach = 1;      // texels on each side: what light is there, and how much paths scatter
constexpr double kAroundPaths = 16;  // of the whole rectangle's scatter, beside those: few paths know it badly

LevelColour added(const LevelColour& a, const LevelColour& b, float sign)
{
    return {a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2]};
}

LevelColour cut_at_white(const LevelColour& levels)
{
    return {std::min(levels[0], 255.0f), std::min(levels[1], 255.0f), std::min(levels[2], 255.0f)};
}

// By how much squares grow from one line to the other, a mean of the channels.
double growth(const ToneLine& from, const ToneLine& to)
{
    double sum = 0;
    for (size_t c = 0; c < 3; ++c) {
        const double ratio = static_cast<double>(to.slope[c][c] / from.slope[c][c]);
        sum += ratio * ratio / 3;
    }
    return sum;
}

// Tangents lie above the curve: where expectations of different views are wrong by noise, the sums are too bright.
// Where they truly differ, the encoded mean light is brighter than the mean of what is shown. So the darker one is
// right.
Rgb darker_light(const EncodedTone& tone, const TexelLight& t)
{
    const Rgb summed = tone.invertible_line_at(t.line.levels).inverse(t.target);
    return {std::min(summed.r, t.light.r), std::min(summed.g, t.light.g), std::min(summed.b, t.light.b)};
}

// Calls f(index) for the texels around (x, y), itself among them.
template <class Function>
void around(int x, int y, int width, int height, Function f)
{
    for (int j = std::max(y - kAroundReach, 0); j <= std::min(y + kAroundReach, height - 1); ++j)
        for (int i = std::max(x - kAroundReach, 0); i <= std::min(x + kAroundReach, width - 1); ++i)
            f(static_cast<size_t>(j * width + i));
}

class Rectangle
{
public:
    Rectangle(const EncodedTone& tone, const std::vector<TexelLight>& light, uint32_t width)
        : tone_(tone), light_(light), width_(static_cast<int>(width)), height_(static_cast<int>(light.size()) / width_)
    {
        for (const TexelLight& t : light) means_.push_back(t.paths == 0 ? Rgb() : darker_light(tone, t));
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) lines_.push_back(line_at(x, y));
    }

    std::vector<LevelColour> smoothed() const
    {
        std::vector<LevelColour> texels;
        for (size_t t = 0; t < light_.size(); ++t) {
            const TexelLight& own = light_[t];
            texels.push_back(own.paths == 0 ? own.target : added(lines_[t](means_[t]), own.tables, -1));
        }
        smooth_noise(texels.data(), variances(), static_cast<uint32_t>(width_));
        for (size_t t = 0; t < light_.size(); ++t) {
            if (light_[t].paths == 0) continue;
            const LevelColour levels = added(texels[t], light_[t].tables, 1);
            texels[t] = added(tone_.encoded(lines_[t].inverse(levels)), light_[t].tables, -1);
        }
        return texels;
    }

private:
    // Around the mean light there, so that neighbours have about the same.
    ToneLine line_at(int x, int y) const
    {
        Rgb sum;
        float paths = 0;
        around(x, y, width_, height_, [&](size_t t) {
            sum = sum + means_[t] * static_cast<float>(light_[t].paths);
            paths += static_cast<float>(light_[t].paths);
        });
        return tone_.invertible_line_at(cut_at_white(tone_.encoded(sum * (1 / std::max(paths, 1.0f)))));
    }

    // Of texels' means where paths scatter as they do all around; negative without paths.
    std::vector<double> variances() const
    {
        std::vector<double> scatter;
        double all = 0, paths = 0;
        for (size_t t = 0; t < light_.size(); ++t) {
            scatter.push_back(light_[t].scatter * growth(light_[t].line, lines_[t]));
            all += scatter[t];
            paths += light_[t].paths;
        }
        std::vector<double> result;
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x) {
                double squares = kAroundPaths * all / std::max(paths, 1.0), count = kAroundPaths;
                around(x, y, width_, height_, [&](size_t t) {
                    squares += scatter[t];
                    count += light_[t].paths;
                });
                const uint32_t own = light_[static_cast<size_t>(y * width_ + x)].paths;
                result.push_back(own == 0 ? -1 : squares / count / own);
            }
        }
        return result;
    }

    const EncodedTone& tone_;
    const std::vector<TexelLight>& light_;
    const int width_, height_;
    std::vector<Rgb> means_;
    std::vector<ToneLine> lines_;
};

}  // namespace

std::vector<LevelColour> finished(const EncodedTone& tone, const std::vector<TexelLight>& light, uint32_t width)
{
    return Rectangle(tone, light, width).smoothed();
}

}  // namespace lumi::baker
