// SPDX-License-Identifier: MIT
#include "pack/view_quantiser.h"

#include <algorithm>
#include <cmath>

#include "fit/node_products.h"
#include "image/k_means.h"

namespace lumi::baker
{
namespace
{

using detail::format::kNodeColours;
using detail::format::kViewNodes;

// Levels, root mean square. Tables that show less take a tenth of a file and gain nothing (docs/log/surface.md).
constexpr double kLeastDifference = 8;
constexpr int kSharedRounds = 12;
constexpr uint64_t kViewSeed = 0x76696577;
constexpr float kGainUnit = 64;
constexpr float kMostLevel = 127;  // the largest level of a channel, either sign

float dot(const LevelColour& a, const LevelColour& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Colours of one node over all vertices: shape, how large each vertex makes it, and what the error counts there.
struct Wanted {
    LevelColour colour;
    float gain, weight;
    uint32_t vertex;
};

float error_of(const Wanted& w, const LevelColour& centre)
{
    float sum = 0;
    for (size_t c = 0; c < 3; ++c) {
        const float d = w.colour[c] - w.gain * centre[c];
        sum += d * d;
    }
    return sum * w.weight;
}

class Quantiser
{
public:
    Quantiser(const FitSums& sums, const FitModel& model, const std::vector<uint8_t>& viewed)
        : sums_(sums),
          model_(model),
          viewed_(viewed),
          weights_(node_weights(sums)),
          gains_(viewed.size(), 0),
          codes_(viewed.size())
    {
        for (size_t v = 0; v < viewed_.size(); ++v) {
            double floor = 0;
            for (size_t k = 0; k < kViewNodes; ++k) floor += weights_[v * kViewNodes + k];
            floor *= kUnseenWeight / kViewNodes;
            for (size_t k = 0; k < kViewNodes; ++k) weights_[v * kViewNodes + k] += floor;
        }
    }

    QuantisedViews result()
    {
        first_gains();
        seed_centres();
        for (int round = 0; round < kSharedRounds; ++round) {
            assign();
            move_centres();
            fit_gains();
        }
        settle();
        return {colours_, codes_};
    }

private:
    static constexpr double kUnseenWeight = 0.02;  // weight of nodes that no path met, as a share of the mean weight

    const LevelColour& node(size_t v, size_t k) const { return model_.nodes[v * kViewNodes + k]; }
    float weight(size_t v, size_t k) const { return static_cast<float>(weights_[v * kViewNodes + k]); }

    // The root mean square of a table.
    void first_gains()
    {
        constexpr float kTypical = 32;  // a table's root mean square that gets the gain 1
        for (size_t v = 0; v < viewed_.size(); ++v) {
            if (viewed_[v] == 0) continue;
            float sum = 0, weights = 0;
            for (size_t k = 0; k < kViewNodes; ++k) {
                sum += weight(v, k) * dot(node(v, k), node(v, k));
                weights += weight(v, k);
            }
            gains_[v] = rounded_gain(std::sqrt(sum / std::max(weights, 1e-6f)) / kTypical);
        }
    }

    // In units of the format, at least 1.
    static uint8_t rounded_gain(float gain)
    {
        return static_cast<uint8_t>(std::clamp(std::round(gain * kGainUnit), 1.0f, 255.0f));
    }
    float gain(size_t v) const { return static_cast<float>(gains_[v]) / kGainUnit; }

    std::vector<Wanted> wanted(size_t k) const
    {
        std::vector<Wanted> result;
        for (uint32_t v = 0; v < viewed_.size(); ++v)
            if (viewed_[v] != 0) result.push_back({node(v, k), gain(v), weight(v, k), v});
        return result;
    }

    void seed_centres()
    {
        for (size_t k = 0; k < kViewNodes; ++k) {
            const std::vector<Wanted> all = wanted(k);
            std::vector<float> distances;
            for (const Wanted& w : all) distances.push_back(error_of(w, centres_[k][0]));
            Sampler sampler(kViewSeed, static_cast<uint32_t>(k), 0);
            for (size_t c = 1; c < kNodeColours; ++c) {
                sampler.start(static_cast<uint32_t>(c));
                const std::optional<size_t> chosen = drawn_by_distance(distances, sampler);
                if (!chosen) break;
                for (size_t channel = 0; channel < 3; ++channel) {
                    centres_[k][c][channel] =
                        std::clamp(all[*chosen].colour[channel] / all[*chosen].gain, -kMostLevel, kMostLevel);
                }
                for (size_t i = 0; i < all.size(); ++i)
                    distances[i] = std::min(distances[i], error_of(all[i], centres_[k][c]));
            }
        }
    }

    void assign()
    {
        for (size_t k = 0; k < kViewNodes; ++k) {
            for (const Wanted& w : wanted(k)) {
                size_t best = 0;
                for (size_t c = 1; c < kNodeColours; ++c)
                    best = error_of(w, centres_[k][c]) < error_of(w, centres_[k][best]) ? c : best;
                codes_[w.vertex].colours[k] = static_cast<uint8_t>(best);
                codes_[w.vertex].gain = gains_[w.vertex];
            }
        }
    }

    void move_centres()
    {
        for (size_t k = 0; k < kViewNodes; ++k) {
            std::array<LevelColour, kNodeColours> sums{};
            std::array<float, kNodeColours> weights{};
            for (const Wanted& w : wanted(k)) {
                const size_t c = codes_[w.vertex].colours[k];
                for (size_t channel = 0; channel < 3; ++channel)
                    sums[c][channel] += w.weight * w.gain * w.colour[channel];
                weights[c] += w.weight * w.gain * w.gain;
            }
            for (size_t c = 0; c < kNodeColours; ++c)
                for (size_t channel = 0; channel < 3 && weights[c] > 0; ++channel)
                    centres_[k][c][channel] = std::clamp(sums[c][channel] / weights[c], -kMostLevel, kMostLevel);
        }
    }

    void fit_gains()
    {
        for (size_t v = 0; v < viewed_.size(); ++v) {
            if (viewed_[v] == 0) continue;
            float wanted_sum = 0, size = 0;
            for (size_t k = 0; k < kViewNodes; ++k) {
                const LevelColour& centre = centres_[k][codes_[v].colours[k]];
                wanted_sum += weight(v, k) * dot(node(v, k), centre);
                size += weight(v, k) * dot(centre, centre);
            }
            if (size > 0) gains_[v] = rounded_gain(wanted_sum / size);
        }
    }

    // Errors of nodes that paths saw together cancel where they can: what each node shows, and the colours that there
    // are, is chosen to be best with all others as they are.
    void settle()
    {
        constexpr int kSweeps = 6, kLastSweeps = 3;
        const NodeProducts products(sums_);
        find_errors();
        for (int sweep = 0; sweep < kSweeps; ++sweep) {
            assign_jointly(products);
            move_centres_jointly(products);
            find_errors();
        }
        round_centres();
        find_errors();
        for (int sweep = 0; sweep < kLastSweeps; ++sweep) assign_jointly(products);
    }

    void find_errors()
    {
        errors_.resize(model_.nodes.size());
        for (size_t v = 0; v < viewed_.size(); ++v)
            for (size_t k = 0; k < kViewNodes; ++k)
                errors_[v * kViewNodes + k] = error_with(v, k, codes_[v].colours[k]);
    }

    // What the errors of other nodes ask of this one.
    LevelColour pull_on(const NodeProducts& products, size_t node) const
    {
        LevelColour pull{};
        for (const NodeProducts::Entry& entry : products.row(node))
            for (size_t c = 0; c < 3; ++c) pull[c] += entry.product * errors_[entry.node][c];
        return pull;
    }

    void assign_jointly(const NodeProducts& products)
    {
        for (size_t v = 0; v < viewed_.size(); ++v) {
            for (size_t k = 0; k < kViewNodes && viewed_[v] != 0; ++k) {
                const size_t here = v * kViewNodes + k;
                codes_[v].colours[k] = best_with(v, k, pull_on(products, here));
                errors_[here] = error_with(v, k, codes_[v].colours[k]);
            }
        }
    }

    void move_centres_jointly(const NodeProducts& products)
    {
        constexpr float kPull = 0.5f;  // vertices that share a colour pull at each other, too
        for (size_t k = 0; k < kViewNodes; ++k) {
            std::array<LevelColour, kNodeColours> sums{};
            std::array<float, kNodeColours> weights{};
            for (size_t v = 0; v < viewed_.size(); ++v) {
                if (viewed_[v] == 0) continue;
                const size_t here = v * kViewNodes + k, code = codes_[v].colours[k];
                const LevelColour pull = pull_on(products, here);
                for (size_t c = 0; c < 3; ++c) sums[code][c] += gain(v) * (weight(v, k) * errors_[here][c] + pull[c]);
                weights[code] += gain(v) * gain(v) * weight(v, k);
            }
            for (size_t code = 0; code < kNodeColours; ++code) {
                for (size_t c = 0; c < 3 && weights[code] > 0; ++c) {
                    float& channel = centres_[k][code][c];
                    channel = std::clamp(channel - kPull * sums[code][c] / weights[code], -kMostLevel, kMostLevel);
                }
            }
        }
    }

    LevelColour error_with(size_t v, size_t k, size_t code) const
    {
        LevelColour e = node(v, k);
        const float g = viewed_[v] != 0 ? gain(v) : 0;
        for (size_t c = 0; c < 3; ++c) e[c] = g * centres_[k][code][c] - e[c];
        return e;
    }

    uint8_t best_with(size_t v, size_t k, const LevelColour& pull) const
    {
        size_t best = 0;
        float least = 0;
        for (size_t code = 0; code < kNodeColours; ++code) {
            const LevelColour e = error_with(v, k, code);
            const float cost = weight(v, k) * dot(e, e) + 2 * dot(pull, e);
            if (code == 0 || cost < least) {
                least = cost;
                best = code;
            }
        }
        return static_cast<uint8_t>(best);
    }

    void round_centres()
    {
        for (size_t k = 0; k < kViewNodes; ++k) {
            for (size_t c = 0; c < kNodeColours; ++c) {
                for (size_t channel = 0; channel < 3; ++channel) {
                    float& value = centres_[k][c][channel];
                    value = std::round(value);
                    colours_.colours[k][c][channel] = static_cast<int8_t>(value);
                }
            }
        }
    }

    const FitSums& sums_;
    const FitModel& model_;
    const std::vector<uint8_t>& viewed_;
    std::vector<double> weights_;
    std::vector<uint8_t> gains_;
    std::vector<ViewCode> codes_;
    std::array<std::array<LevelColour, kNodeColours>, kViewNodes> centres_{};
    NodeColours colours_;
    std::vector<LevelColour> errors_;  // by node: how far what is shown is off
};

}  // namespace

std::vector<uint8_t> viewed_vertices(const FitSums& sums, const FitModel& model)
{
    const std::vector<double> weights = node_weights(sums);
    std::vector<uint8_t> viewed;
    for (size_t v = 0; v < sums.shape().mesh.positions.size(); ++v) {
        double sum = 0, all = 0;
        for (size_t k = v * kViewNodes; k < (v + 1) * kViewNodes; ++k) {
            sum += weights[k] * static_cast<double>(dot(model.nodes[k], model.nodes[k])) / 3;
            all += weights[k];
        }
        viewed.push_back(sum > kLeastDifference * kLeastDifference * all ? 1 : 0);
    }
    return viewed;
}

QuantisedViews quantised(const FitSums& sums, const FitModel& model, const std::vector<uint8_t>& viewed)
{
    return Quantiser(sums, model, viewed).result();
}

std::vector<LevelColour> decoded(const QuantisedViews& q)
{
    std::vector<LevelColour> nodes(kViewNodes * q.views.size());
    for (size_t v = 0; v < q.views.size(); ++v) {
        const float gain = static_cast<float>(q.views[v].gain) / kGainUnit;
        for (size_t k = 0; k < kViewNodes; ++k) {
            const NodeColours::Colour& c = q.colours.colours[k][q.views[v].colours[k]];
            for (size_t channel = 0; channel < 3; ++channel)
                nodes[v * kViewNodes + k][channel] = gain * static_cast<float>(c[channel]);
        }
    }
    return nodes;
}

}  // namespace lumi::baker
