// SPDX-License-Identifier: MIT
#include "pack/view_quantiser.h"

#include <algorithm>
#include <cmath>

#include "fit/view_smoothness.h"
#include "image/palette.h"

namespace lumi::baker
{
namespace
{

using detail::format::kViewNodes;

// With a table at every vertex. Where some get none, codes have more bits.
constexpr uint32_t kPlannedCodeBits = 3;
constexpr int kSharedRounds = 12;
constexpr uint64_t kViewSeed = 0x76696577;
constexpr float kGainUnit = 64;
constexpr float kMostLevel = 127;  // the largest level of a channel, either sign

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

// In units of the format, at least 1.
uint8_t rounded_gain(float gain)
{
    return static_cast<uint8_t>(std::clamp(std::round(gain * kGainUnit), 1.0f, 255.0f));
}

class Quantiser
{
public:
    Quantiser(const FitSums& sums, const FitModel& model, const std::vector<uint8_t>& viewed, uint32_t bits)
        : sums_(sums),
          nodes_(model.nodes),
          weights_(node_weights(sums)),
          views_(viewed.size()),
          bits_(bits),
          centres_(kViewNodes << bits)
    {
        for (uint32_t v = 0; v < viewed.size(); ++v)
            if (viewed[v] != 0) vertices_.push_back(v);
        for (const uint32_t v : vertices_) weigh_unseen(&weights_[v * kViewNodes]);
    }

    QuantisedViews result()
    {
        if (vertices_.empty()) return {{}, views_};
        first_gains();
        seed_centres();
        for (int round = 0; round < kSharedRounds; ++round) {
            assign();
            move_centres();
            fit_gains();
        }
        settle();
        return {rounded_colours(), views_};
    }

private:
    size_t colours() const { return size_t{1} << bits_; }
    LevelColour& centre(size_t k, size_t code) { return centres_[(k << bits_) + code]; }
    const LevelColour& centre(size_t k, size_t code) const { return centres_[(k << bits_) + code]; }
    const LevelColour& node(size_t v, size_t k) const { return nodes_[v * kViewNodes + k]; }
    float weight(size_t v, size_t k) const { return static_cast<float>(weights_[v * kViewNodes + k]); }
    float gain(size_t v, size_t c) const { return static_cast<float>(views_[v].gains[c]) / kGainUnit; }

    // Nodes that no path met count a little, too.
    static void weigh_unseen(double* weights)
    {
        constexpr double kUnseenWeight = 0.02;  // as a share of the mean weight
        double sum = 0;
        for (size_t k = 0; k < kViewNodes; ++k) sum += weights[k];
        for (size_t k = 0; k < kViewNodes; ++k) weights[k] += sum * kUnseenWeight / kViewNodes;
    }

    // The root mean square of a table, by channel.
    void first_gains()
    {
        constexpr float kTypical = 32;  // this gets the gain 1
        for (const uint32_t v : vertices_) {
            LevelColour sums{};
            float weights = 0;
            for (size_t k = 0; k < kViewNodes; ++k) {
                for (size_t c = 0; c < 3; ++c) sums[c] += weight(v, k) * node(v, k)[c] * node(v, k)[c];
                weights += weight(v, k);
            }
            for (size_t c = 0; c < 3; ++c)
                views_[v].gains[c] = rounded_gain(std::sqrt(sums[c] / std::max(weights, 1e-6f)) / kTypical);
        }
    }

    void seed_centres()
    {
        for (size_t k = 0; k < kViewNodes; ++k) {
            std::vector<float> distances;
            for (const uint32_t v : vertices_) distances.push_back(weight(v, k) * square(error_with(v, k, 0)));
            Sampler sampler(kViewSeed, static_cast<uint32_t>(k), 0);
            for (size_t code = 1; code < colours(); ++code) {
                sampler.start(static_cast<uint32_t>(code));
                const std::optional<size_t> chosen = drawn_by_distance(distances, sampler);
                if (!chosen) break;
                const uint32_t at = vertices_[*chosen];
                for (size_t c = 0; c < 3; ++c)
                    centre(k, code)[c] = std::clamp(node(at, k)[c] / gain(at, c), -kMostLevel, kMostLevel);
                for (size_t i = 0; i < vertices_.size(); ++i) {
                    const uint32_t v = vertices_[i];
                    distances[i] = std::min(distances[i], weight(v, k) * square(error_with(v, k, code)));
                }
            }
        }
    }

    void assign()
    {
        for (const uint32_t v : vertices_)
            for (size_t k = 0; k < kViewNodes; ++k) views_[v].codes[k] = best_with(v, k, {});
    }

    void move_centres()
    {
        for (size_t k = 0; k < kViewNodes; ++k) {
            std::vector<LevelColour> sums(colours()), weights(colours());
            for (const uint32_t v : vertices_) {
                const size_t code = views_[v].codes[k];
                for (size_t c = 0; c < 3; ++c) {
                    sums[code][c] += weight(v, k) * gain(v, c) * node(v, k)[c];
                    weights[code][c] += weight(v, k) * gain(v, c) * gain(v, c);
                }
            }
            for (size_t code = 0; code < colours(); ++code) {
                for (size_t c = 0; c < 3; ++c)
                    if (weights[code][c] > 0)
                        centre(k, code)[c] = std::clamp(sums[code][c] / weights[code][c], -kMostLevel, kMostLevel);
            }
        }
    }

    void fit_gains()
    {
        for (const uint32_t v : vertices_) {
            LevelColour wanted{}, size{};
            for (size_t k = 0; k < kViewNodes; ++k) {
                const LevelColour& shape = centre(k, views_[v].codes[k]);
                for (size_t c = 0; c < 3; ++c) {
                    wanted[c] += weight(v, k) * node(v, k)[c] * shape[c];
                    size[c] += weight(v, k) * shape[c] * shape[c];
                }
            }
            for (size_t c = 0; c < 3; ++c)
                if (size[c] > 0) views_[v].gains[c] = rounded_gain(wanted[c] / size[c]);
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
        for (LevelColour& colour : centres_)
            for (float& channel : colour) channel = std::round(channel);
        find_errors();
        for (int sweep = 0; sweep < kLastSweeps; ++sweep) assign_jointly(products);
    }

    // Without a table all that a node would show is missing.
    void find_errors()
    {
        errors_.resize(nodes_.size());
        for (size_t k = 0; k < nodes_.size(); ++k) errors_[k] = difference({}, nodes_[k]);
        for (const uint32_t v : vertices_)
            for (size_t k = 0; k < kViewNodes; ++k) errors_[v * kViewNodes + k] = error_with(v, k, views_[v].codes[k]);
    }

    // The change that the errors of other nodes ask of this one.
    LevelColour pull_on(const NodeProducts& products, size_t node) const
    {
        LevelColour pull{};
        for (const NodeProducts::Entry& entry : products.row(node))
            for (size_t c = 0; c < 3; ++c) pull[c] += entry.product * errors_[entry.node][c];
        return pull;
    }

    void assign_jointly(const NodeProducts& products)
    {
        for (const uint32_t v : vertices_) {
            for (size_t k = 0; k < kViewNodes; ++k) {
                const size_t here = v * kViewNodes + k;
                views_[v].codes[k] = best_with(v, k, pull_on(products, here));
                errors_[here] = error_with(v, k, views_[v].codes[k]);
            }
        }
    }

    void move_centres_jointly(const NodeProducts& products)
    {
        constexpr float kPull = 0.5f;  // vertices that share a colour pull at each other, too
        for (size_t k = 0; k < kViewNodes; ++k) {
            std::vector<LevelColour> sums(colours()), weights(colours());
            for (const uint32_t v : vertices_) {
                const size_t here = v * kViewNodes + k, code = views_[v].codes[k];
                const LevelColour pull = pull_on(products, here);
                for (size_t c = 0; c < 3; ++c) {
                    sums[code][c] += gain(v, c) * (weight(v, k) * errors_[here][c] + pull[c]);
                    weights[code][c] += gain(v, c) * gain(v, c) * weight(v, k);
                }
            }
            for (size_t code = 0; code < colours(); ++code) {
                for (size_t c = 0; c < 3; ++c) {
                    float& channel = centre(k, code)[c];
                    if (weights[code][c] > 0)
                        channel =
                            std::clamp(channel - kPull * sums[code][c] / weights[code][c], -kMostLevel, kMostLevel);
                }
            }
        }
    }

    LevelColour error_with(size_t v, size_t k, size_t code) const
    {
        return difference(scaled(centre(k, code), views_[v].gains), node(v, k));
    }

    uint8_t best_with(size_t v, size_t k, const LevelColour& pull) const
    {
        size_t best = 0;
        float least = 0;
        for (size_t code = 0; code < colours(); ++code) {
            const LevelColour e = error_with(v, k, code);
            const float cost = weight(v, k) * square(e) + 2 * (pull[0] * e[0] + pull[1] * e[1] + pull[2] * e[2]);
            if (code == 0 || cost < least) {
                least = cost;
                best = code;
            }
        }
        return static_cast<uint8_t>(best);
    }

    NodeColours rounded_colours() const
    {
        NodeColours result;
        result.bits = bits_;
        result.colours.clear();
        for (const LevelColour& c : centres_)
            result.colours.push_back({static_cast<int8_t>(c[0]), static_cast<int8_t>(c[1]), static_cast<int8_t>(c[2])});
        return result;
    }

    const FitSums& sums_;
    const std::vector<LevelColour>& nodes_;
    std::vector<double> weights_;
    std::vector<uint32_t> vertices_;  // that have a table
    std::vector<ViewCode> views_;     // by vertex
    const uint32_t bits_;
    std::vector<LevelColour> centres_;  // 2^bits a node
    std::vector<LevelColour> errors_;   // by node: how far what is shown is off
};

uint64_t table_bytes(uint32_t viewed, uint32_t bits)
{
    return detail::format::view_colours_bytes(bits) + uint64_t{viewed} * detail::format::view_bytes(bits);
}

}  // namespace

uint64_t planned_view_bytes(const PatchMesh& mesh, bool view_tables)
{
    if (!view_tables) return table_bytes(0, kPlannedCodeBits);
    const std::vector<uint8_t> viewable = viewable_vertices(mesh);
    return table_bytes(static_cast<uint32_t>(std::count(viewable.begin(), viewable.end(), 1)), kPlannedCodeBits);
}

uint32_t code_bits_for(uint64_t bytes, uint32_t viewed)
{
    uint32_t bits = 1;
    while (bits < detail::format::kMaxCodeBits && (uint32_t{1} << bits) < viewed &&
           table_bytes(viewed, bits + 1) <= bytes)
        ++bits;
    return bits;
}

QuantisedViews quantised(const FitSums& sums, const FitModel& model, const std::vector<uint8_t>& viewed, uint32_t bits)
{
    return Quantiser(sums, model, viewed, bits).result();
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
