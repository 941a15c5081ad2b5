// SPDX-License-Identifier: MIT
#include "mesh/sheets.h"

#include <numeric>
#include <tuple>

namespace lumi::baker
{
namespace
{

// An edge, the triangle that has it, and whether that runs from the lower vertex to the higher.
struct SheetSide {
    uint32_t low, high, triangle;
    bool upwards;
};

bool same_edge(const SheetSide& a, const SheetSide& b)
{
    return a.low == b.low && a.high == b.high;
}

// Sorted by edge.
std::vector<SheetSide> sheet_sides(const Mesh& mesh)
{
    std::vector<SheetSide> sides;
    sides.reserve(3 * mesh.triangle_count());
    for (uint32_t k = 0; k < mesh.triangle_count(); ++k) {
        const Mesh::Corners& c = mesh.corners[k];
        if (is_degenerate(c)) continue;
        for (size_t i = 0; i < 3; ++i) {
            const uint32_t a = c[i], b = c[(i + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), k, a < b});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const SheetSide& a, const SheetSide& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return sides;
}

}  // namespace

Sheets::Sheets(const Mesh& mesh)
    : parent_(mesh.triangle_count()), size_(mesh.triangle_count(), 1), reversed_(mesh.triangle_count(), false)
{
    std::iota(parent_.begin(), parent_.end(), 0u);
    const std::vector<SheetSide> sides = sheet_sides(mesh);
    for (size_t k = 0, end = 0; k < sides.size(); k = end) {
        while (end < sides.size() && same_edge(sides[k], sides[end])) ++end;
        if (end - k == 2) join(sides[k].triangle, sides[k + 1].triangle, sides[k].upwards == sides[k + 1].upwards);
    }
}

SheetPlace Sheets::of(uint32_t triangle) const
{
    bool reversed = false;
    while (parent_[triangle] != triangle) {
        reversed = reversed != reversed_[triangle];
        triangle = parent_[triangle];
    }
    return {triangle, reversed};
}

void Sheets::join(uint32_t a, uint32_t b, bool reversed)
{
    const SheetPlace at_a = of(a), at_b = of(b);
    if (at_a.sheet != at_b.sheet) {
        const bool swap = size_[at_a.sheet] < size_[at_b.sheet];  // the smaller one moves: paths stay short
        const uint32_t root = swap ? at_b.sheet : at_a.sheet, moved = swap ? at_a.sheet : at_b.sheet;
        parent_[moved] = root;
        reversed_[moved] = (at_a.reversed != at_b.reversed) != reversed;
        size_[root] += size_[moved];
    }
}

}  // namespace lumi::baker
