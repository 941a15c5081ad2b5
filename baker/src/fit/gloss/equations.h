// SPDX-License-Identifier: MIT
// The least-squares problem from which gloss maps are learnt. A line's levels are those of its texel, of nine nodes of
// view tables and of four texels of a map. Texels are eliminated: each takes the mean of its lines. Conjugate gradients
// solve the rest, whose neighbours are held alike.
#pragma once

#include "fit/gloss/lines.h"

namespace lumi::baker
{

using GlossColours = std::vector<LevelColour>;
inline constexpr uint32_t kGlossTexels = detail::format::kGlossSide * detail::format::kGlossSide;

// Adds so many times a colour.
void add(LevelColour& sum, const LevelColour& c, float weight);
LevelColour difference(const LevelColour& a, const LevelColour& b);
double squares(const GlossColours& colours);  // of all channels

// Where the lines of each texel begin, and the end. Lines of a texel follow each other.
std::vector<size_t> texel_begins(const std::vector<GlossLine>& lines);
// Takes the mean of each texel off its lines.
void take_means(const std::vector<size_t>& begins, GlossColours& lines);

class GlossEquations
{
public:
    // `choices` by patch: 0, or its map from 1 on.
    GlossEquations(const FitShape& shape, const std::vector<GlossLine>& lines, const std::vector<Vec3>& normals,
                   const std::vector<uint8_t>& choices, uint32_t maps);

    // Nodes by vertex, and behind them the texels of one map after the other.
    size_t unknowns() const { return nodes_ + map_texels_; }
    size_t nodes() const { return nodes_; }

    // Return the lines' colours that unknowns give; shown() less the mean of each texel.
    GlossColours summed(const GlossColours& unknowns) const;
    GlossColours shown(const GlossColours& unknowns) const;
    // Returns what lines that have a map would show if all had this one, counted from 0, and no nodes.
    GlossColours shown_by_map(const GlossColours& unknowns, uint32_t map) const;
    // The transpose of shown().
    GlossColours gathered(const GlossColours& lines) const;
    // Adds what keeps neighbours alike.
    void add_smoothness(const GlossColours& unknowns, GlossColours& sum) const;
    float diagonal(size_t unknown) const { return diagonal_[unknown]; }

private:
    struct Row {
        std::array<uint32_t, 9> nodes;
        std::array<float, 9> weights;
        std::array<uint16_t, 4> texels;  // of a map
        std::array<float, 4> shares;     // 0 without a map
        uint8_t map;                     // its number from 1 on, or 0
    };
    // Two unknowns of a vertex, or of a map, that lie beside each other.
    using Pair = std::pair<uint32_t, uint32_t>;

    Row row_of(const FitShape& shape, const GlossLine& line, const std::vector<Vec3>& normals, uint8_t choice) const;
    template <class Function>
    void each_unknown(const Row& row, Function f) const;

    size_t nodes_, map_texels_;
    std::vector<Pair> node_pairs_, texel_pairs_;
    std::vector<size_t> begins_;  // rows of a texel, and the end
    std::vector<Row> rows_;
    std::vector<float> diagonal_;
};

// The state of conjugate gradients with the diagonal as preconditioner, each channel by itself.
struct GlossGradients {
    GlossColours unknowns, residual, direction;
    std::array<double, 3> products{};  // of the residual and what the preconditioner makes of it
};

template <class Io>
void fields(Io& io, GlossGradients& g)
{
    io(g.unknowns, g.residual, g.direction, g.products);
}

// Borrows both.
class GlossSolver
{
public:
    // `levels` of lines are less the mean of each texel.
    GlossSolver(const GlossEquations& equations, const GlossColours& levels) : equations_(equations), levels_(levels) {}

    GlossGradients begun() const;
    void advance(GlossGradients& gradients) const;

private:
    GlossColours preconditioned(const GlossColours& residual) const;

    const GlossEquations& equations_;
    const GlossColours& levels_;
};

}  // namespace lumi::baker
