// SPDX-License-Identifier: MIT
#include "guided/mean_fit.h"

namespace lumi::baker
{
namespace
{

constexpr float kSmoothness = 0.03f;  // against one for every point
constexpr int kSteps = 200;
constexpr double kEnough = 1e-8;  // of the first residual's square

size_t stencil_of(uint32_t from, uint32_t to)
{
    // Corners k of a cell: their bits are the axes.
    const auto step = [&](uint32_t axis) { return (to >> axis & 1) + 1 - (from >> axis & 1); };
    return step(0) + 3 * (step(1) + 3 * size_t{step(2)});
}

struct Sums {
    double r = 0, g = 0, b = 0;
};

Sums dot(const std::vector<Levels>& a, const std::vector<Levels>& b)
{
    Sums sum;
    for (size_t k = 0; k < a.size(); ++k) {
        sum.r += static_cast<double>(a[k].r * b[k].r);
        sum.g += static_cast<double>(a[k].g * b[k].g);
        sum.b += static_cast<double>(a[k].b * b[k].b);
    }
    return sum;
}

Levels ratio(const Sums& a, const Sums& b)
{
    const auto safe = [](double x, double y) { return y > 0 ? static_cast<float>(x / y) : 0.0f; };
    return {safe(a.r, b.r), safe(a.g, b.g), safe(a.b, b.b)};
}

void add_scaled(std::vector<Levels>& a, const Levels& s, const std::vector<Levels>& b)
{
    for (size_t k = 0; k < a.size(); ++k) {
        a[k] = {a[k].r + s.r * b[k].r, a[k].g + s.g * b[k].g, a[k].b + s.b * b[k].b};
    }
}

}  // namespace

MeanFit::MeanFit(const NodeGrid& grid)
    : grid_(grid),
      matrix_(kStencil * grid.size(), 0),
      right_side_(grid.size()),
      neighbours_(kStencil * grid.size(), NodeGrid::kNone)
{
    const int64_t side = grid.side();
    for (size_t node = 0; node < grid.size(); ++node) {
        const int64_t place = grid.place(node), x = place % side, y = place / side % side, z = place / side / side;
        for (int64_t k = 0; k < int64_t{kStencil}; ++k) {
            const int64_t nx = x + k % 3 - 1, ny = y + k / 3 % 3 - 1, nz = z + k / 9 - 1;
            if (std::min({nx, ny, nz}) < 0 || std::max({nx, ny, nz}) >= side) {
                continue;
            }
            neighbours_[kStencil * node + static_cast<size_t>(k)] =
                grid.at(static_cast<uint32_t>(nx), static_cast<uint32_t>(ny), static_cast<uint32_t>(nz));
        }
        for (const size_t k : {4u, 10u, 12u, 14u, 16u, 22u}) {  // across the faces
            if (neighbours_[kStencil * node + k] != NodeGrid::kNone) {
                matrix_[kStencil * node + k] -= kSmoothness;
                matrix_[kStencil * node + 13] += kSmoothness;
            }
        }
    }
}

void MeanFit::add(const Vec3& x, const Levels& colour)
{
    const NodeGrid::Lookup found = grid_.lookup(x);
    for (uint32_t a = 0; a < 8; ++a) {
        if (found.node[a] == NodeGrid::kNone) {
            return;
        }
    }
    for (uint32_t a = 0; a < 8; ++a) {
        right_side_[found.node[a]] = right_side_[found.node[a]] + colour * found.weight[a];
        for (uint32_t b = 0; b < 8; ++b) {
            matrix_[kStencil * found.node[a] + stencil_of(a, b)] += found.weight[a] * found.weight[b];
        }
    }
}

std::vector<Levels> MeanFit::apply(const std::vector<Levels>& x) const
{
    std::vector<Levels> y(x.size());
    for (size_t node = 0; node < x.size(); ++node) {
        for (size_t k = 0; k < kStencil; ++k) {
            const uint32_t other = neighbours_[kStencil * node + k];
            if (other != NodeGrid::kNone) {
                y[node] = y[node] + x[other] * matrix_[kStencil * node + k];
            }
        }
    }
    return y;
}

// Conjugate gradients, each node scaled by its own diagonal.
std::vector<Levels> MeanFit::solve() const
{
    const auto scaled = [&](std::vector<Levels> r) {
        for (size_t node = 0; node < r.size(); ++node) {
            const float diagonal = matrix_[kStencil * node + 13];
            r[node] = r[node] * (diagonal > 0 ? 1 / diagonal : 0);
        }
        return r;
    };
    std::vector<Levels> x(grid_.size()), r = right_side_;
    std::vector<Levels> z = scaled(r), p = z;
    Sums rz = dot(r, z);
    const double enough = kEnough * (rz.r + rz.g + rz.b);
    for (int k = 0; k < kSteps && rz.r + rz.g + rz.b > enough; ++k) {
        const std::vector<Levels> ap = apply(p);
        const Levels step = ratio(rz, dot(p, ap));
        add_scaled(x, step, p);
        add_scaled(r, step * -1, ap);
        z = scaled(r);
        const Sums next = dot(r, z);
        const Levels turn = ratio(next, rz);
        std::vector<Levels> direction = z;
        add_scaled(direction, turn, p);
        p = std::move(direction);
        rz = next;
    }
    return x;
}

}  // namespace lumi::baker
