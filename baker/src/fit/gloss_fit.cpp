// SPDX-License-Identifier: MIT
#include "fit/gloss_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fit/gloss_lines.h"
#include "lumi/surface/format.h"

namespace lumi::baker
{
namespace
{

using detail::format::kViewNodes;
constexpr uint32_t kTexels = detail::format::kGlossSide * detail::format::kGlossSide;
constexpr uint8_t kNoMap = 0;

using Colours = std::vector<LevelColour>;

LevelColour operator-(const LevelColour& a, const LevelColour& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

void add(LevelColour& sum, const LevelColour& c, float weight)
{
    for (size_t k = 0; k < 3; ++k) sum[k] += weight * c[k];
}

// Mean normals of the lines at the vertices, in the sense of least squares over the triangles: by Jacobi's method.
std::vector<Vec3> normals_of(const FitShape& shape, const std::vector<GlossLine>& lines)
{
    constexpr int kRounds = 25;
    constexpr float kPrior = 1;  // lines that stand for the mesh's own normal
    const auto weights = [](const GlossLine& l) {
        return std::array<float, 3>{1 - l.second - l.third, l.second, l.third};
    };
    const auto vertex = [&](const GlossLine& l, uint32_t k) {
        return shape.vertex(l.triangle / 2, FitShape::patch_corner(l.triangle, k));
    };
    std::vector<Vec3> normals = shape.mesh.normals;
    std::vector<float> diagonal(normals.size(), kPrior);
    for (const GlossLine& l : lines)
        for (uint32_t k = 0; k < 3; ++k) diagonal[vertex(l, k)] += weights(l)[k];
    for (int round = 0; round < kRounds; ++round) {
        std::vector<Vec3> steps(normals.size());
        for (const GlossLine& l : lines) {
            const std::array<float, 3> w = weights(l);
            Vec3 off = l.normal;
            for (uint32_t k = 0; k < 3; ++k) off = off - normals[vertex(l, k)] * w[k];
            for (uint32_t k = 0; k < 3; ++k) steps[vertex(l, k)] = steps[vertex(l, k)] + off * w[k];
        }
        for (size_t v = 0; v < normals.size(); ++v) normals[v] = normals[v] + steps[v] * (1 / diagonal[v]);
    }
    for (size_t v = 0; v < normals.size(); ++v)
        normals[v] = length(normals[v]) > 0.1f ? normalized(normals[v]) : shape.mesh.normals[v];
    return normals;
}

// Neighbours among the nodes of a view table: directions at most 32° apart.
std::vector<std::pair<uint32_t, uint32_t>> node_neighbours()
{
    constexpr float kNear = 0.85f;
    std::vector<Vec3> nodes;
    for (uint32_t k = 0; k < kViewNodes; ++k) {
        const double z = 1 - (2.0 * k + 1) / detail::format::kViewLattice, r = std::sqrt(1 - z * z);
        const double turn = k * 0.6180339887498949 * 2 * 3.141592653589793;
        nodes.push_back(
            {static_cast<float>(r * std::cos(turn)), static_cast<float>(r * std::sin(turn)), static_cast<float>(z)});
    }
    std::vector<std::pair<uint32_t, uint32_t>> pairs;
    for (uint32_t a = 0; a < kViewNodes; ++a)
        for (uint32_t b = a + 1; b < kViewNodes; ++b)
            if (dot(nodes[a], nodes[b]) > kNear) pairs.push_back({a, b});
    return pairs;
}

// The equations of the lines: a line's levels are those of its texel, of nine nodes and of four texels of a map.
class Equations
{
public:
    struct Row {
        std::array<uint32_t, 9> nodes;
        std::array<float, 9> weights;
        std::array<uint32_t, 4> texels;  // of all maps
        std::array<float, 4> shares;     // 0 without a map
    };

    // `choices` by patch.
    Equations(const FitShape& shape, const std::vector<GlossLine>& lines, const std::vector<Vec3>& normals,
              const std::vector<uint8_t>& choices, uint32_t maps)
        : nodes_(shape.mesh.positions.size() * kViewNodes), map_texels_(maps * kTexels), neighbours_(node_neighbours())
    {
        for (const GlossLine& l : lines) rows_.push_back(row_of(shape, l, normals, choices[l.triangle / 2]));
        for (size_t k = 0; k < lines.size(); ++k)
            if (k == 0 || lines[k].texel != lines[k - 1].texel) begins_.push_back(k);
        begins_.push_back(lines.size());
        for (size_t k = 0; k < unknowns(); ++k)
            diagonal_.push_back(k < nodes_ ? kNodeWorth + 6 * kNodeBend : 4 * kMapBend);
        for (const Row& r : rows_)
            each_unknown(r, [&](size_t unknown, float weight) { diagonal_[unknown] += weight * weight; });
    }

    size_t unknowns() const { return nodes_ + map_texels_; }
    size_t nodes() const { return nodes_; }

    // What unknowns make of the lines, less the mean of each texel.
    Colours shown(const Colours& x) const
    {
        Colours y(rows_.size());
        for (size_t k = 0; k < rows_.size(); ++k)
            each_unknown(rows_[k], [&](size_t unknown, float weight) { add(y[k], x[unknown], weight); });
        take_means(y);
        return y;
    }
    void take_means(Colours& y) const
    {
        for (size_t t = 0; t + 1 < begins_.size(); ++t) {
            LevelColour mean{};
            const float share = 1 / static_cast<float>(begins_[t + 1] - begins_[t]);
            for (size_t k = begins_[t]; k < begins_[t + 1]; ++k) add(mean, y[k], share);
            for (size_t k = begins_[t]; k < begins_[t + 1]; ++k) y[k] = y[k] - mean;
        }
    }
    // The transpose.
    Colours gathered(const Colours& y) const
    {
        Colours x(unknowns());
        for (size_t k = 0; k < rows_.size(); ++k)
            each_unknown(rows_[k], [&](size_t unknown, float weight) { add(x[unknown], y[k], weight); });
        return x;
    }
    // Adds what keeps unknowns smooth: neighbours are alike.
    void add_smoothness(const Colours& x, Colours& sum) const
    {
        const auto tie = [&](size_t a, size_t b, float worth) {
            const LevelColour off = x[a] - x[b];
            add(sum[a], off, worth);
            add(sum[b], off, -worth);
        };
        for (size_t k = 0; k < nodes_; ++k) add(sum[k], x[k], kNodeWorth);
        for (size_t first = 0; first < nodes_; first += kViewNodes)
            for (const auto& [a, b] : neighbours_) tie(first + a, first + b, kNodeBend);
        for (size_t k = nodes_; k < unknowns(); ++k) {
            add(sum[k], x[k], kMapWorth);
            const size_t place = (k - nodes_) % kTexels;
            if (place % detail::format::kGlossSide + 1 < detail::format::kGlossSide) tie(k, k + 1, kMapBend);
            if (place / detail::format::kGlossSide + 1 < detail::format::kGlossSide)
                tie(k, k + detail::format::kGlossSide, kMapBend);
        }
    }
    float diagonal(size_t unknown) const { return diagonal_[unknown]; }

private:
    // In lines.
    static constexpr float kNodeWorth = 0.05f, kNodeBend = 0.15f, kMapWorth = 0.02f, kMapBend = 1;

    Row row_of(const FitShape& shape, const GlossLine& l, const std::vector<Vec3>& normals, uint8_t choice) const
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
        if (choice == kNoMap) return row;
        const GlossTaps taps = gloss_taps(corners, l.eye);
        for (size_t k = 0; k < 4; ++k) {
            row.texels[k] = (choice - 1u) * kTexels + taps.texels[k];
            row.shares[k] = taps.weights[k];
        }
        return row;
    }

    template <class Function>
    void each_unknown(const Row& r, Function f) const
    {
        for (size_t k = 0; k < r.nodes.size(); ++k) f(r.nodes[k], r.weights[k]);
        if (map_texels_ == 0) return;
        for (size_t k = 0; k < r.texels.size(); ++k) f(nodes_ + r.texels[k], r.shares[k]);
    }

    const size_t nodes_, map_texels_;
    const std::vector<std::pair<uint32_t, uint32_t>> neighbours_;
    std::vector<Row> rows_;
    std::vector<size_t> begins_;  // rows of a texel, and the end
    std::vector<float> diagonal_;
};

std::array<double, 3> products(const Colours& a, const Colours& b)
{
    std::array<double, 3> sum{};
    for (size_t k = 0; k < a.size(); ++k)
        for (size_t c = 0; c < 3; ++c) sum[c] += static_cast<double>(a[k][c]) * static_cast<double>(b[k][c]);
    return sum;
}

double squares(const Colours& y)
{
    const std::array<double, 3> p = products(y, y);
    return p[0] + p[1] + p[2];
}

// Conjugate gradients with the diagonal as preconditioner, each channel by itself, as far as they came.
struct GlossGradients {
    Colours unknowns, residual, direction;
    std::array<double, 3> products{};  // of the residual and what the preconditioner makes of it
};

template <class Io>
void fields(Io& io, GlossGradients& g)
{
    io(g.unknowns, g.residual, g.direction, g.products);
}

class GlossSolver
{
public:
    // `levels` are less the mean of each texel.
    GlossSolver(const Equations& equations, const Colours& levels) : equations_(equations), levels_(levels) {}

    GlossGradients begun() const
    {
        GlossGradients g = {Colours(equations_.unknowns()), equations_.gathered(levels_), {}};
        g.direction = preconditioned(g.residual);
        g.products = products(g.residual, g.direction);
        return g;
    }

    void advance(GlossGradients& g) const
    {
        Colours q = equations_.gathered(equations_.shown(g.direction));
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
        const Colours z = preconditioned(g.residual);
        const std::array<double, 3> next = products(g.residual, z);
        for (size_t c = 0; c < 3; ++c) keep[c] = g.products[c] > 0 ? static_cast<float>(next[c] / g.products[c]) : 0;
        g.products = next;
        for (size_t k = 0; k < z.size(); ++k)
            for (size_t c = 0; c < 3; ++c) g.direction[k][c] = z[k][c] + keep[c] * g.direction[k][c];
    }

    double squares_left(const Colours& unknowns) const
    {
        const Colours shown = equations_.shown(unknowns);
        Colours left = levels_;
        for (size_t k = 0; k < left.size(); ++k) left[k] = left[k] - shown[k];
        return squares(left);
    }

private:
    Colours preconditioned(const Colours& r) const
    {
        Colours z(r.size());
        for (size_t k = 0; k < r.size(); ++k)
            for (size_t c = 0; c < 3; ++c) z[k][c] = r[k][c] / equations_.diagonal(k);
        return z;
    }

    const Equations& equations_;
    const Colours& levels_;
};

// Two problems that are solved side by side.
struct GlossSteps {
    GlossGradients with, without;
};

template <class Io>
void fields(Io& io, GlossSteps& steps)
{
    io(steps.with, steps.without);
}

bool are_of(const GlossGradients& g, const Equations& equations)
{
    const size_t unknowns = equations.unknowns();
    return g.unknowns.size() == unknowns && g.residual.size() == unknowns && g.direction.size() == unknowns;
}

// The unknowns with maps and without.
GlossSteps solved_both(const Equations& with, const Equations& without, const Colours& levels, BakeStages& stages,
                       Job& job)
{
    constexpr uint32_t kRounds = 30, kRoundsAtOnce = 5;
    const GlossSolver solvers[] = {GlossSolver(with, levels), GlossSolver(without, levels)};
    const auto require_shape = [&](const GlossSteps& s) {
        stages.require_shape(are_of(s.with, with) && are_of(s.without, without));
    };
    const auto advance = [&](uint32_t k, GlossSteps& steps) {
        if (k != 0) require_shape(steps);
        job.run(2, [&](uint32_t one) {
            GlossGradients& g = one == 0 ? steps.with : steps.without;
            if (k == 0) g = solvers[one].begun();
            for (uint32_t round = 0; round < kRoundsAtOnce; ++round) solvers[one].advance(g);
        });
        return true;
    };
    GlossSteps steps = stages.in_steps<GlossSteps>("gloss", kRounds / kRoundsAtOnce, advance);
    require_shape(steps);
    return steps;
}

// The direction in which colours differ most, of unit length, its sum positive: by the power method.
LevelColour main_direction(const Colours& colours)
{
    constexpr int kRounds = 30;
    LevelColour direction = {0.577f, 0.577f, 0.577f};
    for (int round = 0; round < kRounds; ++round) {
        LevelColour sum{};
        for (const LevelColour& c : colours)
            add(sum, c, c[0] * direction[0] + c[1] * direction[1] + c[2] * direction[2]);
        const float size = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
        if (!(size > 0)) break;
        direction = {sum[0] / size, sum[1] / size, sum[2] / size};
    }
    return direction;
}

// A map's colours as one colour times bytes. Where it is darkest it adds nothing: texels have the rest.
GlossMap map_of(Colours colours, float& range)
{
    LevelColour mean{};
    for (const LevelColour& c : colours) add(mean, c, 1.0f / kTexels);
    for (LevelColour& c : colours) c = c - mean;
    const LevelColour direction = main_direction(colours);
    std::vector<float> along;
    for (const LevelColour& c : colours)
        along.push_back(c[0] * direction[0] + c[1] * direction[1] + c[2] * direction[2]);
    const auto [least, most] = std::minmax_element(along.begin(), along.end());
    range = *most - *least;
    constexpr float kSteps = 255, kGainUnit = 64;
    GlossMap map;
    std::vector<uint8_t> texels;
    for (const float a : along)
        texels.push_back(static_cast<uint8_t>(range > 0 ? std::lround((a - *least) / range * kSteps) : 0));
    for (size_t c = 0; c < 3; ++c)
        map.gains[c] =
            static_cast<uint8_t>(std::clamp(std::lround(direction[c] * range / kSteps * kGainUnit), 0L, 255L));
    map.texels = bordered(texels);
    return map;
}

// By patch: the map of the material that most lines to it meet. Those that most lines meet get a map, numbered from 1.
std::vector<uint8_t> choices_of(const GlossLines& all, size_t materials)
{
    const std::vector<GlossLine>& lines = all.lines;
    std::vector<size_t> count(materials);
    for (const GlossLine& l : lines) ++count[l.material];
    std::vector<uint32_t> order(materials);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return count[a] > count[b]; });
    std::vector<uint8_t> map_of_material(materials, kNoMap);
    for (uint32_t k = 0; k < detail::format::kMaxGlossMaps && k < materials; ++k)
        if (count[order[k]] != 0) map_of_material[order[k]] = static_cast<uint8_t>(k + 1);
    std::vector<std::array<uint32_t, detail::format::kMaxGlossMaps + 1>> votes(all.others.size());
    for (size_t p = 0; p < votes.size(); ++p) votes[p][kNoMap] = all.others[p];
    for (const GlossLine& l : lines) ++votes[l.triangle / 2][map_of_material[l.material]];
    std::vector<uint8_t> choices;
    for (const auto& v : votes)
        choices.push_back(static_cast<uint8_t>(std::max_element(v.begin(), v.end()) - v.begin()));
    return choices;
}

// What each map alone adds to the lines, squared.
std::vector<double> shares_of_maps(const Equations& e, const Colours& unknowns)
{
    std::vector<double> shares;
    for (size_t first = e.nodes(); first < unknowns.size(); first += kTexels) {
        Colours alone(unknowns.size());
        std::copy_n(unknowns.begin() + static_cast<std::ptrdiff_t>(first), kTexels,
                    alone.begin() + static_cast<std::ptrdiff_t>(first));
        shares.push_back(squares(e.shown(alone)));
    }
    return shares;
}

// Keeps maps that show something beside the others, numbered anew.
Gloss kept_maps(const Equations& e, const Colours& unknowns, std::vector<uint8_t> choices, std::vector<Vec3> normals)
{
    constexpr float kLeastRange = 16;     // levels along the main direction
    constexpr double kLeastShare = 0.15;  // of what all add
    const size_t nodes = e.nodes();
    const std::vector<double> shares = shares_of_maps(e, unknowns);
    const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
    Gloss gloss;
    std::array<uint8_t, detail::format::kMaxGlossMaps + 1> numbers{};
    for (size_t k = 0; nodes + (k + 1) * kTexels <= unknowns.size(); ++k) {
        float range = 0;
        const auto begin = unknowns.begin() + static_cast<std::ptrdiff_t>(nodes + k * kTexels);
        GlossMap map = map_of(Colours(begin, begin + kTexels), range);
        if (range < kLeastRange || shares[k] < kLeastShare * all) continue;
        gloss.maps.push_back(std::move(map));
        numbers[k + 1] = static_cast<uint8_t>(gloss.maps.size());
    }
    if (!gloss.is_there()) return {};
    for (uint8_t& choice : choices) choice = numbers[choice];
    gloss.choices = std::move(choices);
    gloss.normals = std::move(normals);
    return gloss;
}

// Of the squared error of a field without maps, less the noise of the lines, maps leave at most so much.
constexpr double kMostLeft = 0.85;

bool pays(double with, double without, double noise)
{
    return with - noise < kMostLeft * (without - noise);
}

}  // namespace

bool may_gloss(const SceneData& scene, const PatchMesh& mesh, const SurfaceSettings& settings)
{
    const bool has_edges = scene.choice.environment.picture != nullptr || !scene.fixtures.empty();
    return has_edges && settings.view_tables && !settings.draft && mesh.is_matt == 0 && mesh.parts.empty() &&
           scene.states.names.empty() && !scene.medium;
}

Gloss gloss_of(const SceneData& scene, const FitShape& shape, const SurfaceSettings& settings, BakeStages& stages,
               const ProgressCallback& progress)
{
    constexpr size_t kFewest = 1000;
    if (!may_gloss(scene, shape.mesh, settings)) return {};
    Job job(1, settings.threads, progress);
    const JobStage stage(job, Stage::mesh, job.part_of_rest(1), 20);
    const GlossLines all = gloss_lines(scene, shape, settings, stages, job);
    const std::vector<GlossLine>& lines = all.lines;
    if (lines.size() < kFewest) return {};
    const std::vector<uint8_t> choices = choices_of(all, scene.materials.size());
    const std::vector<Vec3> normals = normals_of(shape, lines);
    Colours levels;
    double noise = 0;
    for (const GlossLine& l : lines) {
        levels.push_back(l.levels);
        noise += static_cast<double>(l.noise);
    }
    const uint32_t maps = *std::max_element(choices.begin(), choices.end());
    const Equations with(shape, lines, normals, choices, maps), without(shape, lines, normals, choices, 0);
    with.take_means(levels);
    const GlossSteps solved = solved_both(with, without, levels, stages, job);
    const double left = GlossSolver(with, levels).squares_left(solved.with.unknowns),
                 without_maps = GlossSolver(without, levels).squares_left(solved.without.unknowns);
    if (!pays(left, without_maps, noise)) return {};
    return kept_maps(with, solved.with.unknowns, choices, normals);
}

}  // namespace lumi::baker
