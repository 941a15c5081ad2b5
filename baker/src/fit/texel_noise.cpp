// SPDX-License-Identifier: MIT
#include "fit/texel_noise.h"

#include <algorithm>
#include <cstddef>

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

}  // namespace lumi::baker
