// SPDX-License-Identifier: MIT
// The one file that sees meshoptimizer.
#include "mesh/simplify.h"

#include <meshoptimizer.h>

#include <algorithm>

namespace lumi::baker
{
namespace
{

constexpr double kTolerated = 1.25;  // where more times the triangles asked for remain, topology is given up
constexpr float kMaxError = 0.1f;    // as a share of the extent: a stalled search would swallow whole objects
constexpr float kMaxRoughError = 1;

using Indices = std::vector<uint32_t>;

Indices indices_of(const Mesh& mesh)
{
    Indices indices;
    for (const Mesh::Corners& c : mesh.corners) indices.insert(indices.end(), c.begin(), c.end());
    return indices;
}

template <class Simplifier>
Indices reduced(const Indices& indices, const Simplifier& simplify)
{
    Indices out(indices.size());
    out.resize(simplify(out.data()));
    return out;
}

// Only the vertices that the triangles use.
Mesh compact(const std::vector<Vec3>& positions, const Indices& indices)
{
    Mesh mesh;
    std::vector<int64_t> number(positions.size(), -1);
    const auto corner = [&](uint32_t old) {
        if (number[old] < 0) {
            number[old] = static_cast<int64_t>(mesh.positions.size());
            mesh.positions.push_back(positions[old]);
        }
        return static_cast<uint32_t>(number[old]);
    };
    for (size_t k = 0; k + 2 < indices.size(); k += 3)
        mesh.corners.push_back({corner(indices[k]), corner(indices[k + 1]), corner(indices[k + 2])});
    return mesh;
}

}  // namespace

Simplified simplified(const Mesh& mesh, size_t triangles)
{
    Indices indices = indices_of(mesh);
    if (indices.size() <= 3 * triangles) return {compact(mesh.positions, indices), false};
    const float* positions = &mesh.positions[0].x;
    const size_t vertices = mesh.positions.size();
    indices = reduced(indices, [&](uint32_t* out) {
        return meshopt_simplify(out, indices.data(), indices.size(), positions, vertices, sizeof(Vec3), 3 * triangles,
                                kMaxError, 0, nullptr);
    });
    // Stalled by borders and seams that it must not collapse. The rougher one leaves fewer than asked for.
    const bool rough = static_cast<double>(indices.size()) > 3 * kTolerated * static_cast<double>(triangles);
    if (rough) {
        indices = reduced(
            indices,
            [&](uint32_t* out) {
                return meshopt_simplifySloppy(out, indices.data(), indices.size(), positions, vertices, sizeof(Vec3),
                                              3 * triangles, kMaxRoughError, nullptr);
            });
    }
    return {compact(mesh.positions, indices), rough};
}

}  // namespace lumi::baker
