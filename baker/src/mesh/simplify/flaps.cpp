// SPDX-License-Identifier: MIT
#include "mesh/simplify/steps.h"

#include <algorithm>
#include <unordered_map>

#include "geometry/components.h"

namespace lumi::baker
{
namespace
{

constexpr double kMostLost = 0.02;  // of a body's area

struct Surface {
    std::vector<uint32_t> triangles;
    double area = 0;
};

// The small ones, from the smallest on.
std::vector<Surface> small_surfaces(const Mesh& mesh, const std::vector<uint32_t>& numbers, double small)
{
    std::unordered_map<uint32_t, size_t> places;
    std::vector<Surface> surfaces;
    for (uint32_t k = 0; k < mesh.triangle_count(); ++k) {
        const auto [place, is_new] = places.try_emplace(numbers[k], surfaces.size());
        if (is_new) surfaces.emplace_back();
        surfaces[place->second].triangles.push_back(k);
        surfaces[place->second].area += static_cast<double>(mesh.area(k));
    }
    surfaces.erase(std::remove_if(
                       surfaces.begin(), surfaces.end(), [&](const Surface& s) { return s.area >= small; }),
                   surfaces.end());
    std::stable_sort(surfaces.begin(), surfaces.end(),
                     [](const Surface& a, const Surface& b) { return a.area < b.area; });
    return surfaces;
}

class Flaps
{
public:
    explicit Flaps(const Mesh& mesh) : mesh_(mesh), bodies_(mesh), spare_(mesh.positions.size(), 0)
    {
        for (uint32_t k = 0; k < mesh.triangle_count(); ++k) {
            count(k, uses_);
            spare_[bodies_.of(mesh.corners[k])] += kMostLost * static_cast<double>(mesh.area(k));
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
        double& spare = spare_[bodies_.of(mesh_.corners[flap.triangles[0]])];
        if (!hangs || flap.area > spare) return false;
        spare -= flap.area;
        for (const auto& [edge, n] : own) uses_.at(edge) -= n;
        return true;
    }

private:
    using Uses = std::unordered_map<uint64_t, uint32_t>;  // by edge, how many triangles have it

    void count(uint32_t triangle, Uses& uses) const
    {
        const Mesh::Corners& c = mesh_.corners[triangle];
        for (size_t i = 0; i < 3; ++i) ++uses[edge_key(c[i], c[(i + 1) % 3])];
    }

    const Mesh& mesh_;
    Components bodies_;
    std::vector<double> spare_;  // by body: the area that it may still lose
    Uses uses_;
};

}  // namespace

std::vector<Mesh::Corners> without_flaps(const Mesh& mesh, const std::vector<uint32_t>& surfaces, double small)
{
    const std::vector<Surface> candidates = small_surfaces(mesh, surfaces, small);
    if (candidates.empty()) return mesh.corners;
    Flaps flaps(mesh);
    std::vector<bool> is_left_out(mesh.triangle_count(), false);
    for (const Surface& flap : candidates)
        if (flaps.leave_out(flap))
            for (const uint32_t k : flap.triangles) is_left_out[k] = true;
    std::vector<Mesh::Corners> kept;
    for (size_t k = 0; k < mesh.triangle_count(); ++k)
        if (!is_left_out[k]) kept.push_back(mesh.corners[k]);
    return kept;
}

}  // namespace lumi::baker
