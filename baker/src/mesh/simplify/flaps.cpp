// SPDX-License-Identifier: MIT
#include "mesh/simplify/flaps.h"

#include <algorithm>
#include <unordered_map>

#include "util/disjoint_sets.h"

namespace lumi::baker
{
namespace
{

constexpr double kMostLost = 0.02;  // of a body's area

using Corners = std::vector<uint32_t>;

struct Surface {
    std::vector<uint32_t> triangles;
    double area = 0;
};

class Flaps
{
public:
    Flaps(const std::vector<Vec3>& positions, const Corners& corners, const Corners& surfaces)
        : positions_(positions), corners_(corners), surfaces_(corners.size()), bodies_(positions.size())
    {
        for (uint32_t k = 0; k < corners.size() / 3; ++k) {
            surfaces_[surfaces[k]].triangles.push_back(k);
            surfaces_[surfaces[k]].area += area(k);
            bodies_.join(corners[3 * k], corners[3 * k + 1]);
            bodies_.join(corners[3 * k], corners[3 * k + 2]);
            count(k, uses_);
        }
        spare_.assign(positions.size(), 0);
        for (uint32_t k = 0; k < corners.size() / 3; ++k) spare_[body(k)] += kMostLost * area(k);
    }

    // The smallest first.
    Corners without(double small)
    {
        std::vector<const Surface*> flaps;
        for (const Surface& surface : surfaces_)
            if (!surface.triangles.empty() && surface.area < small) flaps.push_back(&surface);
        std::stable_sort(flaps.begin(), flaps.end(),
                         [](const Surface* a, const Surface* b) { return a->area < b->area; });
        std::vector<bool> is_left_out(corners_.size() / 3, false);
        for (const Surface* flap : flaps)
            if (leave_out(*flap))
                for (const uint32_t k : flap->triangles) is_left_out[k] = true;
        Corners kept;
        for (uint32_t k = 0; k < is_left_out.size(); ++k)
            if (!is_left_out[k]) kept.insert(kept.end(), &corners_[3 * k], &corners_[3 * k] + 3);
        return kept;
    }

private:
    using Uses = std::unordered_map<uint64_t, uint32_t>;  // by edge, how many triangles have it

    double area(uint32_t triangle) const
    {
        const uint32_t* c = &corners_[3 * triangle];
        const Vec3& a = positions_[c[0]];
        return 0.5 * static_cast<double>(length(cross(positions_[c[1]] - a, positions_[c[2]] - a)));
    }

    uint32_t body(uint32_t triangle) { return bodies_.root(corners_[3 * triangle]); }

    void count(uint32_t triangle, Uses& uses) const
    {
        for (uint32_t i = 0; i < 3; ++i) {
            const uint64_t a = corners_[3 * triangle + i], b = corners_[3 * triangle + (i + 1) % 3];
            ++uses[std::min(a, b) << 32 | std::max(a, b)];
        }
    }

    // Whether that is allowed; then it is done.
    bool leave_out(const Surface& flap)
    {
        Uses own;
        for (const uint32_t k : flap.triangles) count(k, own);
        bool hangs = false;
        for (const auto& [edge, n] : own) {
            const uint32_t others = uses_.at(edge) - n;
            if (others == 1) return false;  // there would be a hole
            hangs = hangs || others != 0;
        }
        double& spare = spare_[body(flap.triangles[0])];
        if (!hangs || flap.area > spare) return false;
        spare -= flap.area;
        for (const auto& [edge, n] : own) uses_.at(edge) -= n;
        return true;
    }

    const std::vector<Vec3>& positions_;
    const Corners& corners_;
    std::vector<Surface> surfaces_;
    DisjointSets bodies_;
    std::vector<double> spare_;  // by body: the area that it may still lose
    Uses uses_;
};

}  // namespace

Corners without_flaps(const std::vector<Vec3>& positions, const Corners& corners, const Corners& surfaces, double small)
{
    return Flaps(positions, corners, surfaces).without(small);
}

}  // namespace lumi::baker
