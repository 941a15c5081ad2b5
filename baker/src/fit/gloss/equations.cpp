// SPDX-License-Identifier: MIT
#include "fit/gloss/equations.h"

#include <cmath>

#include "lumi/surface/format.h"

namespace lumi::baker
{
namespace
{

using detail::format::kViewNodes;
using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;

// In lines.
constexpr float kNodeWorth = 0.05f, kNodeBend = 0.15f, kMapWorth = 0.02f, kMapBend = 1;

// Neighbours among the nodes of a view table: directions at most 32° apart.
Pairs node_neighbours()
{
    constexpr float kNear = 0.85f;
    std::vector<Vec3> nodes;
    for (uint32_t k = 0; k < kViewNodes; ++k) {
        const double z = 1 - (2.0 * k + 1) / detail::format::kViewLattice, r = std::sqrt(1 - z * z);
        const double turn = k * 0.6180339887498949 * 2 * 3.141592653589793;
        nodes.push_back(
            {static_cast<float>(r * std::cos(turn)), static_cast<float>(r * std::sin(turn)), static_cast<float>(z)});
    }
    Pairs pairs;
    for (uint32_t a = 0; a < kViewNodes; ++a)
        for (uint32_t b = a + 1; b < kViewNodes; ++b)
            if (dot(nodes[a], nodes[b]) > kNear) pairs.push_back({a, b});
    return pairs;
}

// Neighbours in a map, also across its sides.
Pairs texel_neighbours()
{
    constexpr int kColumns = static_cast<int>(detail::format::kGlossSide);
    Pairs pairs;
    for (int row = 0; row < kColumns; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const uint32_t texel = gloss_texel(column, row);
            for (const uint32_t other : {gloss_texel(column - 1, row), gloss_texel(column + 1, row),
                                         gloss_texel(column, row - 1), gloss_texel(column, row + 1)})
                if (texel < other) pairs.push_back({texel, other});
        }
    }
    return pairs;
}

std::array<double, 3> products(const GlossColours& a, const GlossColours& b)
{
    std::array<double, 3> sum{};
    for (size_t k = 0; k < a.size(); ++k)
        for (size_t c = 0; c < 3; ++c) sum[c] += static_cast<double>(a[k][c]) * static_cast<double>(b[k][c]);
    return sum;
}

}  // namespace

void add(LevelColour& sum, const LevelColour& c, float weight)
{
    for (size_t k = 0; k < 3; ++k) sum[k] += weight * c[k];
}

LevelColour difference(const LevelColour& a, const LevelColour& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double squares(const GlossColours& colours)
{
    const std::array<double, 3> p = products(colours, colours);
    return p[0] + p[1] + p[2];
}

std::vector<size_t> texel_begins(const std::vector<GlossLine>& lines)
{
    std::vector<size_t> begins;
    for (size_t k = 0; k < lines.size(); ++k)
        if (k == 0 || lines[k].texel != lines[k - 1].texel) begins.push_back(k);
    begins.push_back(lines.size());
    return begins;
}

void take_means(const std::vector<size_t>& begins, GlossColours& y)
{
    for (size_t t = 0; t + 1 < begins.size(); ++t) {
        LevelColour mean{};
        const float share = 1 / static_cast<float>(begins[t + 1] - begins[t]);
        for (size_t k = begins[t]; k < begins[t + 1]; ++k) add(mean, y[k], share);
        for (size_t k = begins[t]; k < begins[t + 1]; ++k) y[k] = difference(y[k], mean);
    }
}

template <class Function>
void GlossEquations::each_unknown(const Row& r, Function f) const
{
    for (size_t k = 0; k < r.nodes.size(); ++k) f(r.nodes[k], r.weights[k]);
    if (map_texels_ == 0 || r.map == 0) return;
    const size_t first = nodes_ + (r.map - 1u) * kGlossTexels;
    for (size_t k = 0; k < r.texels.size(); ++k) f(first + r.texels[k], r.shares[k]);
}

GlossEquations::GlossEquations(const FitShape& shape, const std::vector<GlossLine>& lines,
                               const std::vector<Vec3>& normals, const std::vector<uint8_t>& choices, uint32_t maps)
    : nodes_(shape.mesh.positions.size() * kViewNodes),
      map_texels_(maps * kGlossTexels),
      node_pairs_(node_neighbours()),
      texel_pairs_(texel_neighbours()),
      begins_(texel_begins(lines))
{
    for (const GlossLine& l : lines) rows_.push_back(row_of(shape, l, normals, choices[l.triangle / 2]));
    for (size_t k = 0; k < unknowns(); ++k) diagonal_.push_back(k < nodes_ ? kNodeWorth + 6 * kNodeBend : 4 * kMapBend);
    for (const Row& r : rows_)
        each_unknown(r, [&](size_t unknown, float weight) { diagonal_[unknown] += weight * weight; });
}

GlossEquations::Row GlossEquations::row_of(const FitShape& shape, const GlossLine& l, const std::vector<Vec3>& normals,
                                           uint8_t choice) const
{
    Row row{};
    const std::array<float, 3> weights = {1 - l.second - l.third, l.second, l.third};
    const auto step = [](float v) { return static_cast<int16_t>(std::lround(v * kEyeScale)); };
    const EyePoint eye = {step(l.eye.x), step(l.eye.y), step(l.eye.z)};
    std::array<GlossCorner, 3> corners;
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t v = shape.vertex(l.triangle / 2, FitShape::patch_corner(l.triangle, k));
        const detail::ViewTaps taps = shape.taps(v, eye);
        for (size_t tap = 0; tap < 3; ++tap) {
            row.nodes[3 * k + tap] = v * kViewNodes + taps.node[tap];
            row.weights[3 * k + tap] = weights[k] * static_cast<float>(taps.weight_q8[tap]) / 256;
        }
        corners[k] = {shape.mesh.positions[v], normals[v], weights[k]};
    }
    if (choice == 0) return row;
    const GlossTaps taps = gloss_taps(corners, l.eye);
    row.texels = taps.texels;
    row.shares = taps.weights;
    row.map = choice;
    return row;
}

GlossColours GlossEquations::summed(const GlossColours& x) const
{
    GlossColours y(rows_.size());
    for (size_t k = 0; k < rows_.size(); ++k)
        each_unknown(rows_[k], [&](size_t unknown, float weight) { add(y[k], x[unknown], weight); });
    return y;
}

GlossColours GlossEquations::shown(const GlossColours& x) const
{
    GlossColours y = summed(x);
    take_means(begins_, y);
    return y;
}

GlossColours GlossEquations::shown_by_map(const GlossColours& x, uint32_t map) const
{
    GlossColours y(rows_.size());
    for (size_t k = 0; k < rows_.size(); ++k)
        for (size_t n = 0; n < rows_[k].texels.size(); ++n)
            add(y[k], x[nodes_ + map * kGlossTexels + rows_[k].texels[n]], rows_[k].shares[n]);
    take_means(begins_, y);
    return y;
}

GlossColours GlossEquations::gathered(const GlossColours& y) const
{
    GlossColours x(unknowns());
    for (size_t k = 0; k < rows_.size(); ++k)
        each_unknown(rows_[k], [&](size_t unknown, float weight) { add(x[unknown], y[k], weight); });
    return x;
}

void GlossEquations::add_smoothness(const GlossColours& x, GlossColours& sum) const
{
    const auto tie = [&](size_t a, size_t b, float worth) {
        const LevelColour off = difference(x[a], x[b]);
        add(sum[a], off, worth);
        add(sum[b], off, -worth);
    };
    for (size_t k = 0; k < nodes_; ++k) add(sum[k], x[k], kNodeWorth);
    for (size_t first = 0; first < nodes_; first += kViewNodes)
        for (const auto& [a, b] : node_pairs_) tie(first + a, first + b, kNodeBend);
    for (size_t k = nodes_; k < unknowns(); ++k) add(sum[k], x[k], kMapWorth);
    for (size_t first = nodes_; first < unknowns(); first += kGlossTexels)
        for (const auto& [a, b] : texel_pairs_) tie(first + a, first + b, kMapBend);
}

GlossGradients GlossSolver::begun() const
{
    GlossGradients g = {GlossColours(equations_.unknowns()), equations_.gathered(levels_), {}};
    g.direction = preconditioned(g.residual);
    g.products = products(g.residual, g.direction);
    return g;
}

void GlossSolver::advance(GlossGradients& g) const
{
    GlossColours q = equations_.gathered(equations_.shown(g.direction));
    equations_.add_smoothness(g.direction, q);
    const std::array<double, 3> pq = products(g.direction, q);
    std::array<float, 3> step{}, keep{};
    for (size_t c = 0; c < 3; ++c) step[c] = pq[c] > 0 ? static_cast<float>(g.products[c] / pq[c]) : 0;
    for (size_t k = 0; k < g.unknowns.size(); ++k) {
        for (size_t c = 0; c < 3; ++c) {
            g.unknowns[k][c] += step[c] * g.direction[k][c];
            g.residual[k][c] -= step[c] * q[k][c];
        }
    }
    const GlossColours z = preconditioned(g.residual);
    const std::array<double, 3> next = products(g.residual, z);
    for (size_t c = 0; c < 3; ++c) keep[c] = g.products[c] > 0 ? static_cast<float>(next[c] / g.products[c]) : 0;
    g.products = next;
    for (size_t k = 0; k < z.size(); ++k)
        for (size_t c = 0; c < 3; ++c) g.direction[k][c] = z[k][c] + keep[c] * g.direction[k][c];
}

GlossColours GlossSolver::preconditioned(const GlossColours& r) const
{
    GlossColours z(r.size());
    for (size_t k = 0; k < r.size(); ++k)
        for (size_t c = 0; c < 3; ++c) z[k][c] = r[k][c] / equations_.diagonal(k);
    return z;
}

}  // namespace lumi::baker
