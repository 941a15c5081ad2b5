// SPDX-License-Identifier: MIT
#include "surface/texel_fill.h"

#include <cstddef>

namespace lumi::baker
{
namespace
{

constexpr float kForce = 0.5f;  // of each neighbour, in paths
constexpr int kRounds = 30;

}  // namespace

// Gauss and Seidel's iteration of Σ count·(t - fitted)² + Σ force·(t - neighbour)².
void smooth_starved(LevelColour* texels, const std::vector<uint32_t>& counts, uint32_t width)
{
    const auto size = static_cast<ptrdiff_t>(counts.size()), step = static_cast<ptrdiff_t>(width);
    const std::vector<LevelColour> fitted(texels, texels + size);
    std::vector<uint8_t> known(counts.begin(), counts.end());
    for (ptrdiff_t k = 0; k < size; ++k) {
        known[static_cast<size_t>(k)] = counts[static_cast<size_t>(k)] != 0 ? 1 : 0;
    }
    for (int round = 0; round < kRounds; ++round) {
        for (ptrdiff_t k = 0; k < size; ++k) {
            const auto here = static_cast<size_t>(k);
            float weight = static_cast<float>(counts[here]);
            LevelColour sum = {weight * fitted[here][0], weight * fitted[here][1], weight * fitted[here][2]};
            const auto add = [&](bool inside, ptrdiff_t other) {
                if (!inside || known[static_cast<size_t>(other)] == 0) {
                    return;
                }
                weight += kForce;
                for (size_t c = 0; c < 3; ++c) {
                    sum[c] += kForce * texels[other][c];
                }
            };
            add(k % step != 0, k - 1);
            add(k % step != step - 1, k + 1);
            add(k >= step, k - step);
            add(k + step < size, k + step);
            for (size_t c = 0; c < 3 && weight > 0; ++c) {
                texels[k][c] = sum[c] / weight;
            }
            known[here] = weight > 0 ? 1 : 0;
        }
    }
}

}  // namespace lumi::baker
