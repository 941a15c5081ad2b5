// SPDX-License-Identifier: MIT
#include "mesh/copies.h"

#include <algorithm>
#include <numeric>

namespace lumi::baker
{

std::vector<uint32_t> first_copies(const Mesh& mesh)
{
    std::vector<Mesh::Corners> sets = mesh.corners;
    for (Mesh::Corners& set : sets) std::sort(set.begin(), set.end());
    std::vector<uint32_t> order(sets.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return sets[a] < sets[b]; });
    std::vector<uint32_t> first(sets.size());
    for (size_t k = 0; k < order.size(); ++k) {
        const bool is_copy = k != 0 && sets[order[k]] == sets[order[k - 1]];
        first[order[k]] = is_copy ? first[order[k - 1]] : order[k];
    }
    return first;
}

}  // namespace lumi::baker
