// SPDX-License-Identifier: MIT
#include "fit/node_products.h"

namespace lumi::baker
{

namespace
{

// The number of node `local` of patch p's sums among all vertices' nodes.
uint32_t node_of(const FitShape& shape, uint32_t p, uint32_t local)
{
    return shape.vertex(p, local / detail::format::kViewNodes) * detail::format::kViewNodes +
           local % detail::format::kViewNodes;
}

}  // namespace

std::vector<double> node_weights(const FitSums& sums)
{
    const FitShape& shape = sums.shape();
    std::vector<double> weights(detail::format::kViewNodes * shape.mesh.positions.size());
    for (uint32_t p = 0; p < shape.mesh.patches.size(); ++p) {
        sums.patches()[p].pairs.each([&](uint32_t a, uint32_t b, int64_t sum) {
            if (a == b) weights[node_of(shape, p, a)] += kWeightUnit * kWeightUnit * static_cast<double>(sum);
        });
    }
    return weights;
}

NodeProducts::NodeProducts(const FitSums& sums)
{
    const FitShape& shape = sums.shape();
    rows_.resize(detail::format::kViewNodes * shape.mesh.positions.size());
    for (uint32_t p = 0; p < shape.mesh.patches.size(); ++p) {
        sums.patches()[p].pairs.each([&](uint32_t a, uint32_t b, int64_t sum) {
            const uint32_t i = node_of(shape, p, a), j = node_of(shape, p, b);
            const auto product = static_cast<float>(kWeightUnit * kWeightUnit * static_cast<double>(sum));
            if (i != j) {
                rows_[i].push_back({j, product});
                rows_[j].push_back({i, product});
            }
        });
    }
}

}  // namespace lumi::baker
