// SPDX-License-Identifier: MIT
#include "fit/patch_matrix.h"

#include <algorithm>

namespace lumi::baker
{
namespace
{

using Lanes = float __attribute__((vector_size(4 * sizeof(float))));  // three channels, and one that nobody reads
constexpr size_t kRowsAtOnce = 4;                                     // whose sums stay in registers

Lanes lanes_of(const double* channels)
{
    return Lanes{static_cast<float>(channels[0]), static_cast<float>(channels[1]), static_cast<float>(channels[2]), 0};
}

std::vector<uint16_t> seen_nodes(const PatchSums& sums)
{
    std::vector<uint16_t> nodes;
    sums.pairs.each([&](uint32_t a, uint32_t b, int64_t sum) {
        if (a == b && sum != 0) nodes.push_back(static_cast<uint16_t>(a));
    });
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

// Subtracts c cᵀ / n of a texel from the lower triangle.
void eliminate(const std::vector<double>& crossed, uint32_t count, std::vector<double>& matrix)
{
    const size_t n = crossed.size();
    for (size_t i = 0; i < n; ++i) {
        const double factor = crossed[i] / count;
        if (factor == 0) continue;
        double* const row = &matrix[i * n];
        for (size_t j = 0; j <= i; ++j) row[j] -= factor * crossed[j];
    }
}

}  // namespace

PatchMatrix::PatchMatrix(const PatchSums& sums) : nodes_(seen_nodes(sums)), rows_(nodes_.size() * nodes_.size())
{
    const size_t n = nodes_.size();
    std::array<size_t, kPatchNodes> place;
    place.fill(n);
    for (size_t k = 0; k < n; ++k) place[nodes_[k]] = k;
    std::vector<double> matrix(n * n);
    sums.pairs.each([&](uint32_t a, uint32_t b, int64_t sum) {
        if (place[a] < n && place[b] < n)  // else a damaged shard has it
            matrix[place[b] * n + place[a]] = kWeightUnit * kWeightUnit * static_cast<double>(sum);
    });
    std::vector<double> crossed(n);
    for (size_t t = 0; t < sums.texels.size(); ++t) {
        if (sums.texels[t].count == 0) continue;
        for (size_t k = 0; k < n; ++k) crossed[k] = kWeightUnit * sums.crossed[t * kPatchNodes + nodes_[k]];
        eliminate(crossed, sums.texels[t].count, matrix);
    }
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j <= i; ++j)
            rows_[i * n + j] = rows_[j * n + i] = static_cast<float>(sums.weight * matrix[i * n + j]);
}

void PatchMatrix::add_product(const std::vector<double>& nodes, std::vector<double>& part) const
{
    const size_t n = nodes_.size();
    std::array<Lanes, kPatchNodes> x;
    for (size_t k = 0; k < n; ++k) x[k] = lanes_of(&nodes[3 * size_t{nodes_[k]}]);
    for (size_t i = 0; i < n; i += kRowsAtOnce) {
        const size_t rows = std::min(kRowsAtOnce, n - i);
        std::array<const float*, kRowsAtOnce> row;
        for (size_t r = 0; r < kRowsAtOnce; ++r) row[r] = &rows_[std::min(i + r, n - 1) * n];
        std::array<Lanes, kRowsAtOnce> sums = {};
        for (size_t j = 0; j < n; ++j)
            for (size_t r = 0; r < kRowsAtOnce; ++r) sums[r] += row[r][j] * x[j];
        for (size_t r = 0; r < rows; ++r)
            for (size_t c = 0; c < 3; ++c) part[3 * size_t{nodes_[i + r]} + c] += static_cast<double>(sums[r][c]);
    }
}

}  // namespace lumi::baker
