// SPDX-License-Identifier: MIT
#include "fit/fit_solver.h"

#include <cmath>

#include "fit/fit_state.h"

namespace lumi::baker
{
namespace
{

using detail::format::kViewNodes;

constexpr double kGoodEnough = 3e-4;  // the residual, as a share of the first one, at which the solution is taken

std::array<double, 3> dots(const std::vector<double>& a, const std::vector<double>& b)
{
    std::array<double, 3> sums{};
    for (size_t k = 0; k < a.size(); ++k) sums[k % 3] += a[k] * b[k];
    return sums;
}

// The part of the nodes that the texel's samples see in the mean, times their count.
std::array<double, 3> seen(const uint32_t* crossed, const std::vector<double>& nodes)
{
    std::array<double, 3> sums{};
    for (uint32_t j = 0; j < kPatchNodes; ++j) {
        const double weight = kWeightUnit * crossed[j];
        for (size_t c = 0; c < 3; ++c) sums[c] += weight * nodes[3 * j + c];
    }
    return sums;
}

void subtract(const uint32_t* crossed, const std::array<double, 3>& colour, std::vector<double>& result)
{
    for (uint32_t j = 0; j < kPatchNodes; ++j) {
        const double weight = kWeightUnit * crossed[j];
        for (size_t c = 0; c < 3; ++c) result[3 * j + c] -= weight * colour[c];
    }
}

constexpr size_t place_in_block(size_t row, size_t column)
{
    return row * (row + 1) / 2 + column;
}

void factorise(VertexBlock& block)
{
    constexpr float kLeast = 1e-5f;  // of the diagonal: less is rounding
    for (size_t i = 0; i < kViewNodes; ++i) {
        float* const row = &block[place_in_block(i, 0)];
        const float own = row[i];
        for (size_t j = 0; j <= i; ++j) {
            const float* const other = &block[place_in_block(j, 0)];
            float rest = row[j];
            for (size_t k = 0; k < j; ++k) rest -= row[k] * other[k];
            if (j < i)
                row[j] = rest * other[j];
            else
                row[i] = rest > kLeast * own ? 1 / std::sqrt(rest) : 0;
        }
    }
}

// Solves for three channels a node, in place.
void solve_block(const VertexBlock& block, double* numbers)
{
    for (size_t c = 0; c < 3; ++c) {
        std::array<float, kViewNodes> x;
        for (size_t i = 0; i < kViewNodes; ++i) {
            const float* const row = &block[place_in_block(i, 0)];
            auto rest = static_cast<float>(numbers[3 * i + c]);
            for (size_t k = 0; k < i; ++k) rest -= row[k] * x[k];
            x[i] = rest * row[i];
        }
        for (size_t i = kViewNodes; i-- > 0;) {
            x[i] *= block[place_in_block(i, i)];
            for (size_t k = 0; k < i; ++k) x[k] -= block[place_in_block(i, k)] * x[i];
            numbers[3 * i + c] = static_cast<double>(x[i]);
        }
    }
}

}  // namespace

FitSolver::FitSolver(const FitSums& sums, const ViewSmoothness& smoothness, std::vector<uint8_t> viewed, Job& job)
    : sums_(sums), smoothness_(smoothness), viewed_(std::move(viewed)), job_(job), parts_(sums.patches().size())
{
}

FitSolver::Numbers FitSolver::local(uint32_t patch, const Numbers& nodes) const
{
    Numbers result(3 * kPatchNodes);
    for (uint32_t corner = 0; corner < 4; ++corner) {
        const uint32_t v = sums_.shape().vertex(patch, corner);
        if (v != PatchMesh::kNone)
            std::copy_n(nodes.begin() + 3 * v * kViewNodes, 3 * kViewNodes, result.begin() + 3 * corner * kViewNodes);
    }
    return result;
}

void FitSolver::make_matrices()
{
    if (!matrices_.empty()) return;
    matrices_.resize(sums_.patches().size());
    for_patches(sums_.shape(), job_, [&](uint32_t p) { matrices_[p] = PatchMatrix(sums_.patches()[p]); });
}

template <class Function>
void FitSolver::gather(Numbers& result, Function f)
{
    for_patches(sums_.shape(), job_, [&](uint32_t p) {
        parts_[p].assign(3 * kPatchNodes, 0);
        f(p, parts_[p]);
    });
    for (uint32_t p = 0; p < parts_.size(); ++p) {
        for (uint32_t corner = 0; corner < 4; ++corner) {
            const uint32_t v = sums_.shape().vertex(p, corner);
            for (uint32_t k = 0; v != PatchMesh::kNone && k < 3 * kViewNodes; ++k)
                result[3 * v * kViewNodes + k] += parts_[p][3 * corner * kViewNodes + k];
        }
    }
}

void FitSolver::mask(Numbers& numbers) const
{
    for (size_t v = 0; v < viewed_.size(); ++v)
        if (viewed_[v] == 0)
            std::fill_n(numbers.begin() + static_cast<std::ptrdiff_t>(3 * v * kViewNodes), 3 * kViewNodes, 0.0);
}

FitSolver::Numbers FitSolver::right_side()
{
    Numbers result(3 * kViewNodes * sums_.shape().mesh.positions.size());
    gather(result, [&](uint32_t p, Numbers& part) {
        const PatchSums& sums = sums_.patches()[p];
        for (uint32_t j = 0; j < kPatchNodes; ++j)
            for (size_t c = 0; c < 3; ++c)
                part[3 * j + c] = kWeightUnit * kLevelUnit * static_cast<double>(sums.targets[j][c]);
        for (size_t t = 0; t < sums.texels.size(); ++t) {
            const TexelSums& texel = sums.texels[t];
            const double unit = kLevelUnit / std::max(texel.count, 1u);
            subtract(&sums.crossed[t * kPatchNodes],
                     {unit * static_cast<double>(texel.target[0]), unit * static_cast<double>(texel.target[1]),
                      unit * static_cast<double>(texel.target[2])},
                     part);
        }
        for (double& number : part) number *= sums.weight;
    });
    mask(result);
    return result;
}

void FitSolver::make_blocks()
{
    const FitShape& shape = sums_.shape();
    blocks_.assign(shape.mesh.positions.size(), {});
    for (uint32_t p = 0; p < matrices_.size(); ++p) {
        matrices_[p].each([&](uint32_t a, uint32_t b, float number) {
            if (a / kViewNodes == b / kViewNodes && a >= b)
                blocks_[shape.vertex(p, a / kViewNodes)][place_in_block(a % kViewNodes, b % kViewNodes)] += number;
        });
    }
    smoothness_.each([&](uint32_t a, uint32_t b, float number) {
        if (a / kViewNodes == b / kViewNodes && a >= b)
            blocks_[a / kViewNodes][place_in_block(a % kViewNodes, b % kViewNodes)] += number;
    });
    for (VertexBlock& block : blocks_) factorise(block);
}

void FitSolver::apply(const Numbers& nodes, Numbers& result)
{
    std::fill(result.begin(), result.end(), 0.0);
    gather(result, [&](uint32_t p, Numbers& part) { matrices_[p].add_product(local(p, nodes), part); });
    smoothness_.add_gradient(nodes, result);
    mask(result);
}

FitSolver::Numbers FitSolver::preconditioned(const Numbers& residual) const
{
    Numbers z = residual;
    for (size_t v = 0; v < blocks_.size(); ++v) solve_block(blocks_[v], &z[3 * v * kViewNodes]);
    return z;
}

ConjugateGradients FitSolver::begun(const FitModel& model)
{
    make_matrices();
    make_blocks();  // the expectation may have changed
    ConjugateGradients d;
    for (const LevelColour& node : model.nodes)
        for (const float channel : node) d.x.push_back(static_cast<double>(channel));
    mask(d.x);
    Numbers product(d.x.size());
    apply(d.x, product);
    d.residual = right_side();
    for (size_t k = 0; k < product.size(); ++k) d.residual[k] -= product[k];
    d.direction = preconditioned(d.residual);
    d.size = d.first = dots(d.residual, d.direction);
    return d;
}

void FitSolver::advance(ConjugateGradients& d, int iterations)
{
    make_matrices();
    if (blocks_.empty()) make_blocks();
    Numbers product(d.x.size());
    for (int k = 0; k < iterations && !d.done; ++k) {
        apply(d.direction, product);
        const std::array<double, 3> along = dots(d.direction, product);
        std::array<double, 3> step{}, turn{};
        for (size_t c = 0; c < 3; ++c) step[c] = along[c] > 0 ? d.size[c] / along[c] : 0;
        for (size_t i = 0; i < product.size(); ++i) {
            d.x[i] += step[i % 3] * d.direction[i];
            d.residual[i] -= step[i % 3] * product[i];
        }
        const Numbers z = preconditioned(d.residual);
        const std::array<double, 3> next = dots(d.residual, z);
        d.done = true;
        for (size_t c = 0; c < 3; ++c) {
            turn[c] = d.size[c] > 0 ? next[c] / d.size[c] : 0;
            d.done = d.done && next[c] <= kGoodEnough * kGoodEnough * d.first[c];
        }
        d.size = next;
        for (size_t i = 0; i < z.size(); ++i) d.direction[i] = z[i] + turn[i % 3] * d.direction[i];
    }
}

void FitSolver::take(const ConjugateGradients& gradients, FitModel& model)
{
    for (size_t k = 0; k < gradients.x.size(); ++k) model.nodes[k / 3][k % 3] = static_cast<float>(gradients.x[k]);
    fit_texels(model);
}

void FitSolver::solve(FitModel& model, int iterations)
{
    ConjugateGradients gradients = begun(model);
    advance(gradients, iterations);
    take(gradients, model);
}

void FitSolver::fit_texels(FitModel& model)
{
    const FitShape& shape = sums_.shape();
    for (uint32_t p = 0; p < shape.mesh.patches.size(); ++p) {
        const PatchSums& sums = sums_.patches()[p];
        Numbers own;
        for (const LevelColour& node : patch_nodes(shape, model, p)) own.insert(own.end(), node.begin(), node.end());
        for (size_t t = 0; t < sums.texels.size(); ++t) {
            const TexelSums& texel = sums.texels[t];
            if (texel.count == 0) continue;
            const std::array<double, 3> tables = seen(&sums.crossed[t * kPatchNodes], own);
            LevelColour& colour = model.texels[shape.layout.rectangles[p].begin + t];
            for (size_t c = 0; c < 3; ++c) {
                colour[c] =
                    static_cast<float>((kLevelUnit * static_cast<double>(texel.target[c]) - tables[c]) / texel.count);
            }
        }
    }
}

bool is_of(const ConjugateGradients& d, const FitShape& shape)
{
    const size_t numbers = 3 * empty_model(shape).nodes.size();
    return d.x.size() == numbers && d.residual.size() == numbers && d.direction.size() == numbers;
}

}  // namespace lumi::baker
