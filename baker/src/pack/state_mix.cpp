// SPDX-License-Identifier: MIT
#include "pack/state_mix.h"

#include <algorithm>
#include <cmath>

#include "image/palette.h"
#include "image/tone.h"

namespace lumi::baker
{
namespace
{

using detail::format::kPaletteEntries;
using detail::format::kViewNodes;

constexpr float kWhite = 255;

using StatePoint = std::array<float, kMostPointNumbers>;

// Levels of a vertex in each state, as numbers one after the other; of see-through texels what they add.
StatePoint levels_about(const FitShape& shape, const LevelsOfStates& levels, uint32_t texel)
{
    StatePoint point{};
    const float coverage = shape.see_through.empty() ? 1 : shape.see_through[texel].coverage;
    for (size_t s = 0; s < levels.size(); ++s)
        for (size_t c = 0; c < 3; ++c)
            point[3 * s + c] = coverage * std::clamp(levels[s].texels[texel][c], 0.0f, kWhite);
    return point;
}

}  // namespace

LevelColour levels_of(const Rgb8& c)
{
    return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

LevelColour mixed(const std::vector<LevelColour>& levels, const std::vector<Rgb>& factors)
{
    LevelColour result;
    for (size_t c = 0; c < 3; ++c) {
        double sum = 0;
        for (size_t s = 0; s < levels.size(); ++s)
            sum += static_cast<double>(c == 0   ? factors[s].r
                                       : c == 1 ? factors[s].g
                                                : factors[s].b) *
                   srgb_linear(static_cast<double>(std::clamp(levels[s][c], 0.0f, kWhite) / kWhite));
        result[c] = kWhite * static_cast<float>(std::min(srgb_encoded(sum), 1.0));
    }
    return result;
}

std::vector<LevelColour> mixed_texels(const LevelsOfStates& states)
{
    std::vector<Rgb> factors;
    for (const StateLevels& state : states) factors.push_back(state.factor);
    std::vector<LevelColour> result, one(states.size());
    for (size_t t = 0; t < states[0].texels.size(); ++t) {
        for (size_t s = 0; s < states.size(); ++s) one[s] = states[s].texels[t];
        result.push_back(mixed(one, factors));
    }
    return result;
}

namespace
{

// By vertex: the mean of the texels about it, nearer ones count more.
std::vector<StatePoint> vertex_means(const FitShape& shape, const LevelsOfStates& states)
{
    std::vector<StatePoint> sums(shape.mesh.positions.size());
    std::vector<float> weights(sums.size());
    for (uint32_t p = 0; p < shape.mesh.patches.size(); ++p) {
        const PatchRectangle& r = shape.layout.rectangles[p];
        for (uint32_t k = 0; k < r.size(); ++k) {
            const StatePoint point = levels_about(shape, states, r.begin + k);
            const float x = (static_cast<float>(k % r.n) + 0.5f) / static_cast<float>(r.n),
                        y = (static_cast<float>(k / r.n) + 0.5f) / static_cast<float>(r.m);
            for (uint32_t corner = 0; corner < 4; ++corner) {
                const uint32_t v = shape.vertex(p, corner);
                if (v == PatchMesh::kNone) continue;
                const float w = (corner % 2 == 0 ? 1 - x : x) * (corner < 2 ? 1 - y : y);
                for (size_t c = 0; c < sums[v].size(); ++c) sums[v][c] += w * point[c];
                weights[v] += w;
            }
        }
    }
    for (size_t v = 0; v < sums.size(); ++v)
        for (float& c : sums[v]) c /= std::max(weights[v], 1e-6f);
    return sums;
}

// The level of the light of one level less that of another.
float left_of(float level, float less)
{
    const auto linear = [](float v) { return srgb_linear(static_cast<double>(std::clamp(v, 0.0f, kWhite) / kWhite)); };
    return kWhite * static_cast<float>(srgb_encoded(std::max(linear(level) - linear(less), 0.0)));
}

}  // namespace

void take_away(const FitShape& shape, const FitModel& base, FitModel& model)
{
    const std::vector<StatePoint> means = vertex_means(shape, {{base.texels}, {model.texels}});
    for (size_t v = 0; v < means.size(); ++v) {
        for (size_t at = v * kViewNodes; at < (v + 1) * kViewNodes; ++at) {
            for (size_t c = 0; c < 3; ++c) {
                const float less = means[v][c], all = means[v][3 + c];
                model.nodes[at][c] = left_of(all + model.nodes[at][c], less + base.nodes[at][c]) - left_of(all, less);
            }
        }
        model.viewed[v] = model.viewed[v] != 0 || base.viewed[v] != 0 ? 1 : 0;
    }
    for (size_t t = 0; t < model.texels.size(); ++t)
        for (size_t c = 0; c < 3; ++c) model.texels[t][c] = left_of(model.texels[t][c], base.texels[t][c]);
}

std::vector<uint8_t> mean_entries(const FitShape& shape, const LevelsOfStates& states,
                                  const std::vector<PaletteColours>& palettes)
{
    std::vector<StatePoint> entries(kPaletteEntries);
    for (size_t k = 0; k < kPaletteEntries; ++k)
        for (size_t s = 0; s < palettes.size(); ++s)
            for (size_t c = 0; c < 3; ++c)
                entries[k][3 * s + c] = compared_level(states, s, levels_of(palettes[s][k])[c]);
    std::vector<uint8_t> means;
    for (StatePoint mean : vertex_means(shape, states)) {
        for (size_t k = 0; k < 3 * states.size(); ++k) mean[k] = compared_level(states, k / 3, mean[k]);
        means.push_back(static_cast<uint8_t>(nearest_centre(entries, mean).index));
    }
    return means;
}

namespace
{

// Differences of all states together, as gains and the colours of given codes: least squares in turns.
class ViewMixer
{
public:
    ViewMixer(const std::vector<QuantisedViews>& views, std::vector<LevelColour> nodes)
        : nodes_(std::move(nodes)), result_(views[0])
    {
    }

    QuantisedViews result()
    {
        constexpr int kRounds = 3;
        for (int round = 0; round < kRounds; ++round) {
            fit_colours();
            fit_gains();
        }
        fit_colours();
        return result_;
    }

private:
    float gain(size_t v, size_t c) const { return static_cast<float>(result_.views[v].gains[c]) / kGainUnit; }

    void fit_colours()
    {
        const size_t count = size_t{1} << result_.colours.bits;
        std::vector<LevelColour> sums(kViewNodes * count), squares(sums.size());
        for (size_t v = 0; v < result_.views.size(); ++v) {
            if (!result_.views[v].is_there()) continue;
            for (size_t k = 0; k < kViewNodes; ++k) {
                const size_t at = k * count + result_.views[v].codes[k];
                for (size_t c = 0; c < 3; ++c) {
                    sums[at][c] += gain(v, c) * nodes_[v * kViewNodes + k][c];
                    squares[at][c] += gain(v, c) * gain(v, c);
                }
            }
        }
        for (size_t at = 0; at < sums.size(); ++at)
            for (size_t c = 0; c < 3; ++c)
                if (squares[at][c] > 0)
                    result_.colours.colours[at][c] = static_cast<int8_t>(
                        std::clamp(std::round(sums[at][c] / squares[at][c]), -kMostLevel, kMostLevel));
    }

    void fit_gains()
    {
        for (size_t v = 0; v < result_.views.size(); ++v) {
            ViewCode& view = result_.views[v];
            if (!view.is_there()) continue;
            for (size_t c = 0; c < 3; ++c) {
                float wanted = 0, size = 0;
                for (size_t k = 0; k < kViewNodes; ++k) {
                    const float shape = result_.colours.of(k, view.codes[k])[c];
                    wanted += nodes_[v * kViewNodes + k][c] * shape;
                    size += shape * shape;
                }
                if (size > 0)
                    view.gains[c] =
                        static_cast<uint8_t>(std::clamp(std::round(wanted / size * kGainUnit), 1.0f, kWhite));
            }
        }
    }

    const std::vector<LevelColour> nodes_;
    QuantisedViews result_;
};

}  // namespace

QuantisedViews mixed_views(const std::vector<QuantisedViews>& views, const std::vector<PaletteColours>& palettes,
                           const std::vector<Rgb>& factors, const std::vector<uint8_t>& means)
{
    std::vector<std::vector<LevelColour>> nodes;
    for (const QuantisedViews& q : views) nodes.push_back(decoded(q));
    std::vector<LevelColour> mean(views.size()), shown(views.size()), differences(nodes[0].size());
    for (size_t v = 0; v < means.size(); ++v) {
        if (!views[0].views[v].is_there()) continue;
        for (size_t s = 0; s < views.size(); ++s) mean[s] = levels_of(palettes[s][means[v]]);
        const LevelColour all = mixed(mean, factors);
        for (size_t at = v * kViewNodes; at < (v + 1) * kViewNodes; ++at) {
            for (size_t s = 0; s < views.size(); ++s)
                for (size_t c = 0; c < 3; ++c) shown[s][c] = mean[s][c] + nodes[s][at][c];
            const LevelColour seen = mixed(shown, factors);
            for (size_t c = 0; c < 3; ++c) differences[at][c] = seen[c] - all[c];
        }
    }
    return ViewMixer(views, std::move(differences)).result();
}

}  // namespace lumi::baker
