// SPDX-License-Identifier: MIT
#include "pack/view_quantiser.h"

#include <algorithm>
#include <cmath>

#include "fit/view_smoothness.h"
#include "image/palette.h"
#include "store/section_writer.h"

namespace lumi::baker
{
namespace
{

using detail::format::kViewNodes;

// With a table at every vertex. Where some get none, codes have more bits.
constexpr uint32_t kPlannedCodeBits = 3;
constexpr int kSharedRounds = 12;
constexpr uint64_t kViewSeed = 0x76696577;

using Gains = std::array<uint8_t, 3>;

LevelColour scaled(const LevelColour& colour, const Gains& gains)
{
    LevelColour result;
    for (size_t c = 0; c < 3; ++c) result[c] = colour[c] * static_cast<float>(gains[c]) / kGainUnit;
    return result;
}

float square(const LevelColour& a)
{
    return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
}

LevelColour difference(const LevelColour& a, const LevelColour& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// In units of the format.
uint8_t rounded_gain(float gain, float least)
{
    return static_cast<uint8_t>(std::clamp(std::round(gain * kGainUnit), least, 255.0f));
}

// The tables of one state of the light, as they are fitted to.
struct Layer {
    const FitSums& sums;
    const std::vector<LevelColour>& nodes;
    float square_of_times;
    float least_gain;  // 1 of the first: 0 says there that there is no table
    std::vector<double> weights;
    std::vector<Gains> gains;          // by vertex
    std::vector<LevelColour> centres;  // 2^bits a node
    std::vector<LevelColour> errors;   // by node: how far what is shown is off
};

// All states share the codes.
class Quantiser
{
public:
    Quantiser(const std::vector<ViewLayer>& layers, const std::vector<uint8_t>& viewed, uint32_t bits)
        : codes_(viewed.size()), bits_(bits)
    {
        for (uint32_t v = 0; v < viewed.size(); ++v)
            if (viewed[v] != 0) vertices_.push_back(v);
        for (const ViewLayer& l : layers) {
            layers_.push_back({l.sums,
                               l.model.nodes,
                               l.times * l.times,
                               layers_.empty() ? 1.0f : 0.0f,
                               weights_of(l),
                               std::vector<Gains>(viewed.size()),
                               std::vector<LevelColour>(kViewNodes << bits),
                               {}});
            for (const uint32_t v : vertices_) weigh_unseen(&layers_.back().weights[v * kViewNodes]);
        }
    }

    std::vector<QuantisedViews> result()
    {
        if (!vertices_.empty()) {
            for (Layer& l : layers_) first_gains(l);
            seed_centres();
            for (int round = 0; round < kSharedRounds; ++round) {
                assign();
                for (Layer& l : layers_) move_centres(l);
                for (Layer& l : layers_) fit_gains(l);
            }
            settle();
        }
        std::vector<QuantisedViews> result;
        for (const Layer& l : layers_) result.push_back(quantised_of(l));
        return result;
    }

private:
    using Codes = std::array<uint8_t, kViewNodes>;

    size_t colours() const { return size_t{1} << bits_; }
    LevelColour& centre(Layer& l, size_t k, size_t code) const { return l.centres[(k << bits_) + code]; }
    const LevelColour& centre(const Layer& l, size_t k, size_t code) const { return l.centres[(k << bits_) + code]; }
    static const LevelColour& node(const Layer& l, size_t v, size_t k) { return l.nodes[v * kViewNodes + k]; }
    static float weight(const Layer& l, size_t v, size_t k)
    {
        return static_cast<float>(l.weights[v * kViewNodes + k]);
    }
    static float gain(const Layer& l, size_t v, size_t c) { return static_cast<float>(l.gains[v][c]) / kGainUnit; }

    static std::vector<double> weights_of(const ViewLayer& l)
    {
        std::vector<double> weights = node_weights(l.sums);
        for (double& w : weights) w *= static_cast<double>(l.times * l.times);
        return weights;
    }

    // Nodes that no path met count a little, too.
    static void weigh_unseen(double* weights)
    {
        constexpr double kUnseenWeight = 0.02;  // as a share of the mean weight
        double sum = 0;
        for (size_t k = 0; k < kViewNodes; ++k) sum += weights[k];
        for (size_t k = 0; k < kViewNodes; ++k) weights[k] += sum * kUnseenWeight / kViewNodes;
    }

    // The root mean square of a table, by channel.
    void first_gains(Layer& l) const
    {
        constexpr float kTypical = 32;  // this gets the gain 1
        for (const uint32_t v : vertices_) {
            LevelColour sums{};
            float weights = 0;
            for (size_t k = 0; k < kViewNodes; ++k) {
                for (size_t c = 0; c < 3; ++c) sums[c] += weight(l, v, k) * node(l, v, k)[c] * node(l, v, k)[c];
                weights += weight(l, v, k);
            }
            for (size_t c = 0; c < 3; ++c)
                l.gains[v][c] = rounded_gain(std::sqrt(sums[c] / std::max(weights, 1e-6f)) / kTypical, l.least_gain);
        }
    }

    float distance_to(size_t v, size_t k, size_t code) const
    {
        float sum = 0;
        for (const Layer& l : layers_) sum += weight(l, v, k) * square(error_with(l, v, k, code));
        return sum;
    }

    static float seed(const Layer& l, size_t v, size_t k, size_t c)
    {
        const float gain_here = gain(l, v, c);
        return gain_here > 0 ? std::clamp(node(l, v, k)[c] / gain_here, -kMostLevel, kMostLevel) : 0;
    }

    void seed_centres()
    {
        for (size_t k = 0; k < kViewNodes; ++k) {
            std::vector<float> distances;
            for (const uint32_t v : vertices_) distances.push_back(distance_to(v, k, 0));
            Sampler sampler(kViewSeed, static_cast<uint32_t>(k), 0);
            for (size_t code = 1; code < colours(); ++code) {
                sampler.start(static_cast<uint32_t>(code));
                const std::optional<size_t> chosen = drawn_by_distance(distances, sampler);
                if (!chosen) break;
                const uint32_t at = vertices_[*chosen];
                for (Layer& l : layers_)
                    for (size_t c = 0; c < 3; ++c) centre(l, k, code)[c] = seed(l, at, k, c);
                for (size_t i = 0; i < vertices_.size(); ++i)
                    distances[i] = std::min(distances[i], distance_to(vertices_[i], k, code));
            }
        }
    }

    void assign()
    {
        const std::vector<LevelColour> none(layers_.size());
        for (const uint32_t v : vertices_)
            for (size_t k = 0; k < kViewNodes; ++k) codes_[v][k] = best_with(v, k, none);
    }

    void move_centres(Layer& l) const
    {
        for (size_t k = 0; k < kViewNodes; ++k) {
            std::vector<LevelColour> sums(colours()), weights(colours());
            for (const uint32_t v : vertices_) {
                const size_t code = codes_[v][k];
                for (size_t c = 0; c < 3; ++c) {
                    sums[code][c] += weight(l, v, k) * gain(l, v, c) * node(l, v, k)[c];
                    weights[code][c] += weight(l, v, k) * gain(l, v, c) * gain(l, v, c);
                }
            }
            for (size_t code = 0; code < colours(); ++code) {
                for (size_t c = 0; c < 3; ++c)
                    if (weights[code][c] > 0)
                        centre(l, k, code)[c] = std::clamp(sums[code][c] / weights[code][c], -kMostLevel, kMostLevel);
            }
        }
    }

    void fit_gains(Layer& l) const
    {
        for (const uint32_t v : vertices_) {
            LevelColour wanted{}, size{};
            for (size_t k = 0; k < kViewNodes; ++k) {
                const LevelColour& shape = centre(l, k, codes_[v][k]);
                for (size_t c = 0; c < 3; ++c) {
                    wanted[c] += weight(l, v, k) * node(l, v, k)[c] * shape[c];
                    size[c] += weight(l, v, k) * shape[c] * shape[c];
                }
            }
            for (size_t c = 0; c < 3; ++c)
                if (size[c] > 0) l.gains[v][c] = rounded_gain(wanted[c] / size[c], l.least_gain);
        }
    }

    // Errors of nodes that paths saw together cancel where they can: what each node shows, and the colours that there
    // are, is chosen to be best with all others as they are.
    void settle()
    {
        constexpr int kSweeps = 6, kLastSweeps = 3;
        std::vector<NodeProducts> products;
        for (const Layer& l : layers_) products.emplace_back(l.sums);
        find_errors();
        for (int sweep = 0; sweep < kSweeps; ++sweep) {
            assign_jointly(products);
            for (size_t k = 0; k < layers_.size(); ++k) move_centres_jointly(layers_[k], products[k]);
            find_errors();
        }
        for (Layer& l : layers_)
            for (LevelColour& colour : l.centres)
                for (float& channel : colour) channel = std::round(channel);
        find_errors();
        for (int sweep = 0; sweep < kLastSweeps; ++sweep) assign_jointly(products);
    }

    // Without a table all that a node would show is missing.
    void find_errors()
    {
        for (Layer& l : layers_) {
            l.errors.resize(l.nodes.size());
            for (size_t k = 0; k < l.nodes.size(); ++k) l.errors[k] = difference({}, l.nodes[k]);
            for (const uint32_t v : vertices_)
                for (size_t k = 0; k < kViewNodes; ++k)
                    l.errors[v * kViewNodes + k] = error_with(l, v, k, codes_[v][k]);
        }
    }

    // The change that the errors of other nodes ask of this one.
    static LevelColour pull_on(const Layer& l, const NodeProducts& products, size_t node)
    {
        LevelColour pull{};
        for (const NodeProducts::Entry& entry : products.row(node))
            for (size_t c = 0; c < 3; ++c) pull[c] += entry.product * l.errors[entry.node][c];
        for (float& channel : pull) channel *= l.square_of_times;
        return pull;
    }

    void assign_jointly(const std::vector<NodeProducts>& products)
    {
        std::vector<LevelColour> pulls(layers_.size());
        for (const uint32_t v : vertices_) {
            for (size_t k = 0; k < kViewNodes; ++k) {
                const size_t here = v * kViewNodes + k;
                for (size_t i = 0; i < pulls.size(); ++i) pulls[i] = pull_on(layers_[i], products[i], here);
                codes_[v][k] = best_with(v, k, pulls);
                for (Layer& l : layers_) l.errors[here] = error_with(l, v, k, codes_[v][k]);
            }
        }
    }

    void move_centres_jointly(Layer& l, const NodeProducts& products) const
    {
        constexpr float kPull = 0.5f;  // vertices that share a colour pull at each other, too
        for (size_t k = 0; k < kViewNodes; ++k) {
            std::vector<LevelColour> sums(colours()), weights(colours());
            for (const uint32_t v : vertices_) {
                const size_t here = v * kViewNodes + k, code = codes_[v][k];
                const LevelColour pull = pull_on(l, products, here);
                for (size_t c = 0; c < 3; ++c) {
                    sums[code][c] += gain(l, v, c) * (weight(l, v, k) * l.errors[here][c] + pull[c]);
                    weights[code][c] += gain(l, v, c) * gain(l, v, c) * weight(l, v, k);
                }
            }
            for (size_t code = 0; code < colours(); ++code) {
                for (size_t c = 0; c < 3; ++c) {
                    float& channel = centre(l, k, code)[c];
                    if (weights[code][c] > 0)
                        channel =
                            std::clamp(channel - kPull * sums[code][c] / weights[code][c], -kMostLevel, kMostLevel);
                }
            }
        }
    }

    LevelColour error_with(const Layer& l, size_t v, size_t k, size_t code) const
    {
        return difference(scaled(centre(l, k, code), l.gains[v]), node(l, v, k));
    }

    // `pulls`: by state.
    uint8_t best_with(size_t v, size_t k, const std::vector<LevelColour>& pulls) const
    {
        size_t best = 0;
        float least = 0;
        for (size_t code = 0; code < colours(); ++code) {
            float cost = 0;
            for (size_t i = 0; i < layers_.size(); ++i) {
                const LevelColour e = error_with(layers_[i], v, k, code), &pull = pulls[i];
                cost += weight(layers_[i], v, k) * square(e) + 2 * (pull[0] * e[0] + pull[1] * e[1] + pull[2] * e[2]);
            }
            if (code == 0 || cost < least) {
                least = cost;
                best = code;
            }
        }
        return static_cast<uint8_t>(best);
    }

    QuantisedViews quantised_of(const Layer& l) const
    {
        QuantisedViews result;
        result.views.resize(codes_.size());
        if (vertices_.empty()) return result;
        for (const uint32_t v : vertices_) result.views[v] = {l.gains[v], codes_[v]};
        result.colours.bits = bits_;
        result.colours.colours.clear();
        for (const LevelColour& c : l.centres)
            result.colours.colours.push_back(
                {static_cast<int8_t>(c[0]), static_cast<int8_t>(c[1]), static_cast<int8_t>(c[2])});
        return result;
    }

    std::vector<Layer> layers_;
    std::vector<uint32_t> vertices_;  // that have a table
    std::vector<Codes> codes_;        // by vertex
    const uint32_t bits_;
};

uint64_t table_bytes(uint32_t viewed, uint32_t bits, uint32_t states)
{
    namespace format = detail::format;
    const uint64_t own = format::view_colours_bytes(bits) + uint64_t{viewed} * format::view_bytes(bits);
    return states < 2 ? own
                      : own + uint64_t{states} * format::view_colours_bytes(bits) +
                            uint64_t{viewed} * format::state_view_bytes(states);
}

}  // namespace

uint64_t planned_view_bytes(const PatchMesh& mesh, bool view_tables, uint32_t states)
{
    return table_bytes(view_tables ? most_viewed_vertices(mesh, states) : 0, kPlannedCodeBits, states);
}

uint64_t gloss_file_bytes(const PatchMesh& mesh, size_t maps)
{
    namespace format = detail::format;
    if (maps == 0) return 0;
    const uint32_t section =
        format::gloss_bytes(static_cast<uint32_t>(maps), static_cast<uint32_t>(mesh.patches.size()));
    return aligned(section) + aligned(format::kEntryBytes);
}

uint64_t gloss_bytes_beyond_tables(const PatchMesh& mesh, size_t maps)
{
    const uint64_t needed = gloss_file_bytes(mesh, maps),
                   room = planned_view_bytes(mesh) - aligned(table_bytes(most_viewed_vertices(mesh), 1, 1));
    return needed > room ? needed - room : 0;
}

uint32_t code_bits_for(uint64_t bytes, uint32_t viewed, uint32_t states)
{
    uint32_t bits = 1;
    while (bits < detail::format::kMaxCodeBits && (uint32_t{1} << bits) < viewed &&
           table_bytes(viewed, bits + 1, states) <= bytes)
        ++bits;
    return bits;
}

std::vector<QuantisedViews> quantised(const std::vector<ViewLayer>& layers, const std::vector<uint8_t>& viewed,
                                      uint32_t bits)
{
    return Quantiser(layers, viewed, bits).result();
}

std::vector<LevelColour> decoded(const QuantisedViews& q)
{
    std::vector<LevelColour> nodes;
    for (const ViewCode& view : q.views) {
        for (size_t k = 0; k < kViewNodes; ++k) {
            const NodeColours::Colour& c = q.colours.of(k, view.codes[k]);
            nodes.push_back(
                scaled({static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])}, view.gains));
        }
    }
    return nodes;
}

}  // namespace lumi::baker
