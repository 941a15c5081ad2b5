// SPDX-License-Identifier: MIT
// The texels and view tables that fit best what the sums hold.
//
// Texels are eliminated: each is the mean of its targets less what the view tables add. The rest, one equation a node,
// is solved by conjugate gradients, preconditioned by the block of each vertex. The result does not depend on threads.
#pragma once

#include "fit/patch_matrix.h"
#include "fit/view_smoothness.h"
#include "util/job.h"

namespace lumi::baker
{

// Where conjugate gradients stand. Numbers: 3 a node; sums are of each channel.
struct ConjugateGradients {
    std::vector<double> x, residual, direction;
    std::array<double, 3> size{}, first{};  // the residual's size, now and at the beginning
    bool done = false;                      // the residual is small enough
};

template <class Io>
void fields(Io& io, ConjugateGradients& d)
{
    io(d.x, d.residual, d.direction, d.size, d.first, d.done);
}
bool is_of(const ConjugateGradients& gradients, const FitShape& shape);

// The equations among the nodes of one vertex, as Cholesky's lower triangle: row k has k + 1 numbers, and the
// diagonal's inverse is at its end. A node without an equation has 0 there.
using VertexBlock = std::array<float, detail::format::kViewNodes*(detail::format::kViewNodes + 1) / 2>;

class FitSolver
{
public:
    // Borrows the others. Targets of the sums may change between two solutions, and what is expected; paths may not.
    // Nodes of vertices that are not `viewed` stay 0; empty: all are.
    FitSolver(const FitSums& sums, const ViewSmoothness& smoothness, std::vector<uint8_t> viewed, Job& job);

    // From the nodes of `model`, so many iterations, to nodes and texels. In parts, for who keeps what is done: begun,
    // advance, take.
    void solve(FitModel& model, int iterations);
    ConjugateGradients begun(const FitModel& model);
    void advance(ConjugateGradients& gradients, int iterations);
    void take(const ConjugateGradients& gradients, FitModel& model);
    // The texels alone, for the nodes as they are.
    void fit_texels(FitModel& model);

private:
    using Numbers = std::vector<double>;  // 3 a node

    void make_matrices();
    void make_blocks();
    Numbers right_side();
    Numbers preconditioned(const Numbers& residual) const;
    void apply(const Numbers& nodes, Numbers& result);
    void mask(Numbers& numbers) const;

    // f(patch, local numbers of its nodes) for all patches, whose results are then summed.
    template <class Function>
    void gather(Numbers& result, Function f);
    Numbers local(uint32_t patch, const Numbers& nodes) const;

    const FitSums& sums_;
    const ViewSmoothness& smoothness_;
    const std::vector<uint8_t> viewed_;
    Job& job_;
    std::vector<PatchMatrix> matrices_;  // by patch, once they are needed
    std::vector<Numbers> parts_;         // by patch
    std::vector<VertexBlock> blocks_;    // by vertex
};

}  // namespace lumi::baker
