// SPDX-License-Identifier: MIT
#include "surface/fit_basis.h"

#include <algorithm>
#include <cmath>

#include "lumi/surface/format.h"
#include "mesh/mesh_loss.h"
#include "util/byte_stream.h"

namespace lumi::baker
{
namespace
{

constexpr uint32_t kBasisTag = 0x42475253;

bool is_within(float v, float most)
{
    return std::abs(v) <= most;  // false for what is no number
}
bool is_within(const Vec3& v, float most)
{
    return is_within(v.x, most) && is_within(v.y, most) && is_within(v.z, most);
}

// What the code behind counts on; the mesh lies in the unit sphere.
bool is_sound(const FitBasis& basis)
{
    constexpr float kReach = 1.9f, kMostDensity = 1e6f, kMostLight = 1e30f;
    const PatchMesh& mesh = basis.mesh;
    return is_within(mesh.longest_edge, 1e6f) && basis.tone <= kLastToneCurve &&
           std::all_of(mesh.positions.begin(), mesh.positions.end(),
                       [](const Vec3& p) { return is_within(p, kReach); }) &&
           std::all_of(mesh.normals.begin(), mesh.normals.end(), [](const Vec3& n) { return is_within(n, kReach); }) &&
           std::all_of(basis.densities.begin(), basis.densities.end(),
                       [](float d) { return d >= 0 && is_within(d, kMostDensity); }) &&
           std::all_of(basis.see_through.begin(), basis.see_through.end(), [](const SeeThroughTexel& t) {
               const Rgb& light = t.behind;
               return is_within(t.coverage, 1) && is_within(t.open, 1) &&
                      is_within(Vec3{light.r, light.g, light.b}, kMostLight);
           });
}

}  // namespace

template <class Io>
void fields(Io& io, PatchMesh::Patch& patch)
{
    io(patch.a, patch.b, patch.c, patch.d);
}
template <class Io>
void fields(Io& io, PatchMesh& mesh)
{
    io(mesh.longest_edge, mesh.positions, mesh.normals, mesh.patches, mesh.see_through_patches,
       mesh.is_in_drawing_order);
    const size_t vertices = mesh.positions.size();
    io.require(vertices <= detail::format::kMaxSurfaceVertices && mesh.patches.size() <= detail::format::kMaxPatches);
    io.require(mesh.normals.size() == vertices && mesh.see_through_patches <= mesh.patches.size() &&
               mesh.is_in_drawing_order <= 1);
    for (const PatchMesh::Patch& p : mesh.patches)
        io.require(std::max({p.a, p.b, p.c}) < vertices && (p.d < vertices || p.d == PatchMesh::kNone));
}
template <class Io>
void fields(Io& io, FitBasis& basis)
{
    uint32_t tag = kBasisTag;
    io(tag, basis.mesh, basis.densities, basis.loss, basis.tone, basis.sphere.centre, basis.sphere.radius,
       basis.see_through);
    io.require(tag == kBasisTag && basis.densities.size() == basis.mesh.patches.size() && is_sound(basis));
}

std::vector<uint8_t> encode(const FitBasis& basis)
{
    return to_bytes(basis);
}

std::optional<FitBasis> decode_basis(const std::vector<uint8_t>& bytes)
{
    return from_bytes<FitBasis>(bytes);
}

}  // namespace lumi::baker
