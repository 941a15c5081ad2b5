// SPDX-License-Identifier: MIT
#include "fit/texel_finish.h"

#include <algorithm>
#include <cstddef>

#include "fit/starved_patches.h"

namespace lumi::baker
{

namespace
{

constexpr int kDiffusionRounds = 30;
constexpr int kReach = 2;                // edges on each side in the window where differences are compared with noise
constexpr double kLeastVariance = 1e-3;  // levels²
constexpr double kLeastSpread = 0.5;     // least difference taken for the picture's own, in parts of the noise
constexpr double kUnknownTie = 1e-3;     // the tie where nothing around is known

// Texels and what ties them: `across[k]` joins texel k to the one at its right, `down[k]` to the one below.
class Smoother
{
public:
    Smoother(LevelColour* texels, const std::vector<double>& variances, uint32_t width)
        : texels_(texels),
          fitted_(texels, texels + variances.size()),
          width_(static_cast<int>(width)),
          height_(static_cast<int>(variances.size()) / width_)
    {
        for (const double v : variances) trust_.push_back(v < 0 ? 0 : 1 / std::max(v, kLeastVariance));
        across_ = ties(1, 0);
        down_ = ties(0, 1);
    }

    // Gauss and Seidel's iteration of Σ trust·(t - fitted)² + Σ tie·(t - neighbour)².
    void run()
    {
        known_ = trust_;
        for (int round = 0; round < kDiffusionRounds; ++round) {
            for (int y = 0; y < height_; ++y)
                for (int x = 0; x < width_; ++x) relax(x, y);
        }
    }

private:
    size_t at(int x, int y) const { return static_cast<size_t>(y * width_ + x); }
    bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

    // How strongly each texel is drawn to the one at (dx, dy) from it.
    std::vector<double> ties(int dx, int dy) const
    {
        std::vector<double> result(trust_.size());
        for (int y = 0; y + dy < height_; ++y)
            for (int x = 0; x + dx < width_; ++x) result[at(x, y)] = tie(x, y, dx, dy);
        return result;
    }

    // 1/variance of the differences that the picture itself has around there.
    double tie(int x, int y, int dx, int dy) const
    {
        double differences = 0, noise = 0;
        int count = 0;
        for (int j = y - kReach; j <= y + kReach; ++j) {
            for (int i = x - kReach; i <= x + kReach; ++i) {
                if (!has(i, j) || !has(i + dx, j + dy)) continue;
                const size_t a = at(i, j), b = at(i + dx, j + dy);
                if (trust_[a] == 0 || trust_[b] == 0) continue;
                for (size_t c = 0; c < 3; ++c) {
                    const double d = static_cast<double>(fitted_[a][c] - fitted_[b][c]);
                    differences += d * d / 3;
                }
                noise += 1 / trust_[a] + 1 / trust_[b];
                ++count;
            }
        }
        if (count == 0) return kUnknownTie;
        return count / std::max(differences - noise, kLeastSpread * noise);
    }

    void relax(int x, int y)
    {
        const size_t here = at(x, y);
        double weight = trust_[here];
        std::array<double, 3> sum{};
        const auto add = [&](const LevelColour& colour, double w) {
            for (size_t c = 0; c < 3; ++c) sum[c] += w * static_cast<double>(colour[c]);
        };
        add(fitted_[here], weight);
        const auto draw_to = [&](int i, int j, const std::vector<double>& ties, size_t tie) {
            if (!has(i, j) || known_[at(i, j)] == 0) return;
            weight += ties[tie];
            add(texels_[at(i, j)], ties[tie]);
        };
        if (x > 0) draw_to(x - 1, y, across_, at(x - 1, y));
        draw_to(x + 1, y, across_, here);
        if (y > 0) draw_to(x, y - 1, down_, at(x, y - 1));
        draw_to(x, y + 1, down_, here);
        if (weight == 0) return;
        for (size_t c = 0; c < 3; ++c) texels_[here][c] = static_cast<float>(sum[c] / weight);
        known_[here] = weight;
    }

    LevelColour* texels_;
    const std::vector<LevelColour> fitted_;
    const int width_, height_;
    std::vector<double> trust_;  // 1/variance
    std::vector<double> known_;  // not 0 where a texel has a colour
    std::vector<double> across_, down_;
};

}  // namespace

void smooth_noise(LevelColour* texels, const std::vector<double>& variances, uint32_t width)
{
    Smoother(texels, variances, width).run();
}

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

    // The variance of a texel's mean where paths scatter as they do all around; negative without paths.
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

namespace
{

TexelLight light_of(const EncodedTone& tone, const TexelSums& sums, const LevelColour& texel)
{
    const double unit = kLevelUnit / std::max(sums.count, 1u);
    LevelColour expected, target, tables;
    float light[3];
    for (size_t c = 0; c < 3; ++c) {
        const double shown = unit * static_cast<double>(sums.target[c]);
        tables[c] = static_cast<float>(shown) - texel[c];
        target[c] = static_cast<float>(shown + unit * static_cast<double>(sums.cut_off[c]));
        light[c] = static_cast<float>(kLightUnit * static_cast<double>(sums.light[c]) / std::max(sums.count, 1u));
        expected[c] = std::min(255.0f, static_cast<float>(unit * static_cast<double>(sums.predicted[c])));
    }
    const Rgb mean = {light[0], light[1], light[2]};
    const double scatter = kScatterUnit / 3 * static_cast<double>(sums.whole_scatter);
    return {tone.line_at(expected), sums.count == 0 ? texel : target, mean, tables, scatter, sums.count};
}

}  // namespace

void finish_texels(const FitSums& all, const EncodedTone& tone, FitModel& model)
{
    const FitShape& shape = all.shape();
    std::vector<uint32_t> counts(model.texels.size(), 0);  // rectangles do not lie in the order of patches
    for (uint32_t p = 0; p < shape.mesh.patches.size(); ++p) {
        const PatchRectangle& r = shape.layout.rectangles[p];
        const PatchSums& sums = all.patches()[p];
        std::vector<TexelLight> light;
        for (size_t t = 0; t < r.size(); ++t) {
            light.push_back(light_of(tone, sums.texels[t], model.texels[r.begin + t]));
            counts[r.begin + t] = sums.texels[t].count;
        }
        const std::vector<LevelColour> texels = finished(tone, light, r.n);
        std::copy(texels.begin(), texels.end(), model.texels.begin() + r.begin);
    }
    fill_starved_patches(shape, counts, model.texels);
}

}  // namespace lumi::baker
