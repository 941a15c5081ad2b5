// SPDX-License-Identifier: MIT
#include "fit/gloss/map_choices.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "mesh/patch_mesh.h"

namespace lumi::baker
{
namespace
{

constexpr uint8_t kNoMap = 0;
using Choices = std::vector<uint8_t>;

// Each patch has the map that most of the lines to it vote for.
template <class MapOfMaterial>
Choices choices_by_vote(const GlossLines& all, MapOfMaterial map_of)
{
    std::vector<std::array<uint32_t, detail::format::kMaxGlossMaps + 1>> votes(all.others.size());
    for (size_t p = 0; p < votes.size(); ++p) votes[p][kNoMap] = all.others[p];
    for (const GlossLine& l : all.lines) ++votes[l.triangle / 2][map_of(l.material)];
    Choices choices;
    for (const auto& v : votes)
        choices.push_back(static_cast<uint8_t>(std::max_element(v.begin(), v.end()) - v.begin()));
    return choices;
}

// Over the lines to a patch: the map's squares, and its products with what nodes leave.
struct Strength {
    double squares = 0, products = 0;

    // So many times the map leaves least to the patch.
    double factor() const { return products / squares; }
    // Returns how much the squared error falls if the map is weighed by factor().
    double taken() const { return squares > 0 ? products * products / squares : 0; }
    Strength operator+(const Strength& o) const { return {squares + o.squares, products + o.products}; }
    Strength operator-(const Strength& o) const { return {squares - o.squares, products - o.products}; }
};

// Returns what nodes alone show to the lines.
GlossColours shown_by_nodes(const GlossEquations& e, GlossColours unknowns)
{
    std::fill(unknowns.begin() + static_cast<std::ptrdiff_t>(e.nodes()), unknowns.end(), LevelColour{});
    return e.shown(unknowns);
}

// By patch.
std::vector<Strength> strengths_of(const GlossEquations& e, const GlossColours& unknowns, const GlossColours& levels,
                                   const std::vector<GlossLine>& lines, size_t patches)
{
    const GlossColours nodes = shown_by_nodes(e, unknowns), all = e.shown(unknowns);
    std::vector<Strength> strengths(patches);
    for (size_t k = 0; k < lines.size(); ++k) {
        const LevelColour map = difference(all[k], nodes[k]), left = difference(levels[k], nodes[k]);
        Strength& s = strengths[lines[k].triangle / 2];
        for (size_t c = 0; c < 3; ++c) {
            s.squares += static_cast<double>(map[c] * map[c]);
            s.products += static_cast<double>(map[c] * left[c]);
        }
    }
    return strengths;
}

// Patches of a map, the last of which show it more strongly.
struct Split {
    std::vector<uint32_t> weak;
    double gain = 0;  // how much squared error it saves
};

Split best_split(const std::vector<Strength>& strengths, const Choices& choices, uint8_t map)
{
    std::vector<uint32_t> patches;
    Strength all;
    for (uint32_t p = 0; p < choices.size(); ++p) {
        if (choices[p] != map || strengths[p].squares <= 0) continue;
        patches.push_back(p);
        all = all + strengths[p];
    }
    std::stable_sort(patches.begin(), patches.end(),
                     [&](uint32_t a, uint32_t b) { return strengths[a].factor() < strengths[b].factor(); });
    Split best;
    Strength weak;
    size_t count = 0;
    for (size_t k = 0; k + 1 < patches.size(); ++k) {
        weak = weak + strengths[patches[k]];
        const double gain = weak.taken() + (all - weak).taken() - all.taken();
        if (gain <= best.gain) continue;
        best.gain = gain;
        count = k + 1;
    }
    best.weak.assign(patches.begin(), patches.begin() + static_cast<std::ptrdiff_t>(count));
    return best;
}

// By patch, those that share an edge with it. Across creases vertices are parted.
std::vector<std::vector<uint32_t>> neighbours_of(const PatchMesh& mesh)
{
    std::map<std::pair<uint32_t, uint32_t>, std::vector<uint32_t>> sides;
    for (uint32_t p = 0; p < mesh.patches.size(); ++p) {
        const PatchMesh::Patch& patch = mesh.patches[p];
        const uint32_t fourth = patch.d == PatchMesh::kNone ? patch.b : patch.d;
        for (const auto& [from, to] :
             {std::pair{patch.a, patch.b}, {patch.b, fourth}, {fourth, patch.c}, {patch.c, patch.a}})
            if (from != to) sides[std::minmax(from, to)].push_back(p);
    }
    std::vector<std::vector<uint32_t>> neighbours(mesh.patches.size());
    for (const auto& [side, patches] : sides) {
        if (patches.size() != 2) continue;
        neighbours[patches[0]].push_back(patches[1]);
        neighbours[patches[1]].push_back(patches[0]);
    }
    return neighbours;
}

// A map, or none, that patches may take: by patch the squares of what it shows, and of what it leaves.
struct Offer {
    uint8_t map;
    std::vector<double> shown, left;
};

Offer offer_of(uint8_t map, const GlossColours& shown, const GlossColours& levels, const std::vector<GlossLine>& lines,
               size_t patches)
{
    Offer offer = {map, std::vector<double>(patches), std::vector<double>(patches)};
    for (size_t k = 0; k < lines.size(); ++k) {
        const uint32_t p = lines[k].triangle / 2;
        offer.shown[p] += squares({shown[k]});
        offer.left[p] += squares({difference(levels[k], shown[k])});
    }
    return offer;
}

// Each patch takes what leaves least to it; where a neighbour takes something else, a seam shows, which counts for so
// much of what the weaker of the two shows. By iterated conditional modes (Besag, "On the Statistical Analysis of Dirty
// Pictures", 1986).
Choices without_seams(const std::vector<Offer>& offers, const std::vector<std::vector<uint32_t>>& neighbours,
                      Choices choices)
{
    constexpr double kSeam = 0.5;
    constexpr int kRounds = 10;
    const Choices may_have = choices;
    std::vector<double> shown(choices.size());
    for (const Offer& offer : offers)
        for (size_t p = 0; p < shown.size(); ++p) shown[p] = std::max(shown[p], offer.shown[p]);
    const auto cost = [&](size_t p, const Offer& offer, double seam) {
        double sum = offer.left[p];
        for (const uint32_t q : neighbours[p])
            if (choices[q] != offer.map) sum += seam * std::min(shown[p], shown[q]);
        return sum;
    };
    for (int round = 0; round < kRounds; ++round) {
        const double seam = round == 0 ? 0 : kSeam;  // neighbours have chosen from then on
        for (size_t p = 0; p < choices.size(); ++p) {
            if (may_have[p] == kNoMap) continue;
            const auto costs_less = [&](const Offer& a, const Offer& b) { return cost(p, a, seam) < cost(p, b, seam); };
            choices[p] = std::min_element(offers.begin(), offers.end(), costs_less)->map;
        }
    }
    return choices;
}

}  // namespace

std::vector<uint8_t> choices_of_one(const GlossLines& all)
{
    return choices_by_vote(
        all, [](uint32_t) { return uint8_t{1}; });
}

std::vector<uint8_t> choices_by_material(const GlossLines& all, size_t materials, uint32_t most)
{
    std::vector<size_t> count(materials);
    for (const GlossLine& l : all.lines) ++count[l.material];
    std::vector<uint32_t> order(materials);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return count[a] > count[b]; });
    Choices map_of_material(materials, kNoMap);
    for (uint32_t k = 0; k < std::min(most, detail::format::kMaxGlossMaps) && k < materials; ++k)
        if (count[order[k]] != 0) map_of_material[order[k]] = static_cast<uint8_t>(k + 1);
    return choices_by_vote(all, [&](uint32_t material) { return map_of_material[material]; });
}

std::vector<uint8_t> split_choices(const GlossEquations& equations, const GlossColours& unknowns,
                                   const GlossColours& levels, const std::vector<GlossLine>& lines, Choices choices,
                                   uint32_t most)
{
    constexpr double kLeastGain = 0.02;  // of what maps take
    const std::vector<Strength> strengths = strengths_of(equations, unknowns, levels, lines, choices.size());
    double taken = 0;
    for (const Strength& s : strengths) taken += s.taken();
    const uint8_t maps = *std::max_element(choices.begin(), choices.end());
    for (uint8_t count = maps; count < std::min(most, detail::format::kMaxGlossMaps); ++count) {
        Split best;
        for (uint8_t map = 1; map <= count; ++map)
            if (Split split = best_split(strengths, choices, map); split.gain > best.gain) best = std::move(split);
        if (best.gain <= kLeastGain * taken) break;
        for (const uint32_t p : best.weak) choices[p] = static_cast<uint8_t>(count + 1);
    }
    return choices;
}

std::vector<uint8_t> choices_among(const std::vector<uint8_t>& maps, const GlossEquations& equations,
                                   const GlossColours& unknowns, GlossColours levels,
                                   const std::vector<GlossLine>& lines, const PatchMesh& mesh, Choices choices)
{
    const GlossColours nodes = shown_by_nodes(equations, unknowns);
    for (size_t k = 0; k < levels.size(); ++k) levels[k] = difference(levels[k], nodes[k]);
    std::vector<Offer> offers = {offer_of(kNoMap, GlossColours(lines.size()), levels, lines, choices.size())};
    for (const uint8_t map : maps)
        offers.push_back(offer_of(map, equations.shown_by_map(unknowns, map - 1u), levels, lines, choices.size()));
    return without_seams(offers, neighbours_of(mesh), std::move(choices));
}

}  // namespace lumi::baker
