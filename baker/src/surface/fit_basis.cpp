// SPDX-License-Identifier: MIT
#include "surface/fit_basis.h"

#include <algorithm>
#include <cmath>

#include "util/byte_stream.h"

namespace lumi::baker
{
namespace
{

constexpr uint32_t kBasisTag = 0x42465253;

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
    constexpr float kReach = 1.9f, kMostDensity = 1e6f;
    const PatchMesh& mesh = basis.mesh;
    return is_within(mesh.longest_edge, 1e6f) && basis.tone <= ToneCurve::aces &&
           std::all_of(mesh.positions.begin(), mesh.positions.end(),
                       [](const Vec3& p) { return is_within(p, kReach); }) &&
           std::all_of(mesh.normals.begin(), mesh.normals.end(), [](const Vec3& n) { return is_within(n, kReach); }) &&
           std::all_of(basis.densities.begin(), basis.densities.end(),
                       [](float d) { return d >= 0 && is_within(d, kMostDensity); });
}

}  // namespace

std::vector<uint8_t> encode(const FitBasis& basis)
{
    ByteWriter out;
    out.put32(kBasisTag);
    out.put32(static_cast<uint32_t>(basis.mesh.positions.size()));
    out.put32(static_cast<uint32_t>(basis.mesh.patches.size()));
    out.put32(basis.mesh.two_sided ? 1 : 0);
    out.put_float(basis.mesh.longest_edge);
    out.put32(static_cast<uint32_t>(basis.tone));
    for (const double v : {basis.loss.missed, basis.loss.added, basis.loss.displaced, basis.sphere.centre[0],
                           basis.sphere.centre[1], basis.sphere.centre[2], basis.sphere.radius})
        out.put_double(v);
    for (size_t v = 0; v < basis.mesh.positions.size(); ++v) out(basis.mesh.positions[v], basis.mesh.normals[v]);
    for (const PatchMesh::Patch& p : basis.mesh.patches)
        for (const uint32_t corner : {p.a, p.b, p.c, p.d}) out.put32(corner);
    for (const float density : basis.densities) out.put_float(density);
    return out.bytes();
}

std::optional<FitBasis> decode_basis(const std::vector<uint8_t>& bytes)
{
    ByteReader in(bytes.data(), bytes.size());
    FitBasis basis = {};
    const uint32_t tag = in.get32(), vertices = in.get32(), patches = in.get32();
    if (tag != kBasisTag || vertices > format::kMaxSurfaceVertices || patches > format::kMaxPatches)
        return std::nullopt;
    basis.mesh.two_sided = in.get32() != 0;
    basis.mesh.longest_edge = in.get_float();
    basis.tone = static_cast<ToneCurve>(in.get32());
    for (double* v : {&basis.loss.missed, &basis.loss.added, &basis.loss.displaced, &basis.sphere.centre[0],
                      &basis.sphere.centre[1], &basis.sphere.centre[2], &basis.sphere.radius})
        *v = in.get_double();
    for (uint32_t v = 0; v < vertices; ++v) in(basis.mesh.positions.emplace_back(), basis.mesh.normals.emplace_back());
    for (uint32_t p = 0; p < patches; ++p) {
        PatchMesh::Patch patch = {};
        for (uint32_t* corner : {&patch.a, &patch.b, &patch.c, &patch.d}) {
            *corner = in.get32();
            if (*corner >= vertices && (corner != &patch.d || *corner != PatchMesh::kNone)) return std::nullopt;
        }
        basis.mesh.patches.push_back(patch);
    }
    for (uint32_t p = 0; p < patches; ++p) basis.densities.push_back(in.get_float());
    if (!is_sound(basis)) return std::nullopt;
    return basis;
}

}  // namespace lumi::baker
