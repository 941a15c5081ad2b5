// SPDX-License-Identifier: MIT
#include "surface/surface_codec.h"

#include <algorithm>
#include <cmath>

#include "lumi/baker/bake.h"

namespace lumi::baker
{
namespace
{

// Numbers of few bytes where they are small (LEB128), signed ones in zigzag order.
void put_number(ByteWriter& out, uint64_t v)
{
    for (; v >= 0x80; v >>= 7) out.put8(static_cast<uint8_t>(v | 0x80));
    out.put8(static_cast<uint8_t>(v));
}
uint64_t get_number(ByteReader& in)
{
    uint64_t v = 0;
    for (int shift = 0; shift < 64; shift += 7) {
        const uint8_t byte = in.get8();
        v |= uint64_t{byte & 0x7Fu} << shift;
        if (byte < 0x80) break;
    }
    return v;
}
void put_signed(ByteWriter& out, int64_t v)
{
    put_number(out, static_cast<uint64_t>(v) << 1 ^ static_cast<uint64_t>(v >> 63));
}
int64_t get_signed(ByteReader& in)
{
    const uint64_t v = get_number(in);
    return static_cast<int64_t>(v >> 1) ^ -static_cast<int64_t>(v & 1);
}

void put(ByteWriter& out, const std::vector<LevelColour>& colours)
{
    for (const LevelColour& c : colours) put(out, Vec3{c[0], c[1], c[2]});
}

// Reads into `colours` if it may, else tells whether they are the same.
bool get(ByteReader& in, std::vector<LevelColour>& colours, bool into)
{
    bool same = true;
    for (LevelColour& c : colours) {
        const Vec3 v = get_vector(in);
        const LevelColour read = {v.x, v.y, v.z};
        if (into) c = read;
        same = same && c == read;
    }
    return same;
}

void put(ByteWriter& out, const PatchSums& sums)
{
    for (const TexelSums& texel : sums.texels) {
        put_number(out, texel.count);
        for (size_t c = 0; c < 3; ++c) {
            put_signed(out, texel.target[c]);
            put_signed(out, texel.predicted[c]);
        }
        put_number(out, texel.scatter);
    }
    for (const uint32_t crossed : sums.crossed) put_number(out, crossed);
    for (const std::array<int64_t, 3>& target : sums.targets)
        for (const int64_t channel : target) put_signed(out, channel);
    uint64_t pairs = 0;
    sums.pairs.each([&](uint32_t, uint32_t, int64_t) { ++pairs; });
    put_number(out, pairs);
    sums.pairs.each([&](uint32_t a, uint32_t b, int64_t sum) {
        put_number(out, a * kPatchNodes + b);
        put_signed(out, sum);
    });
}

// What a shard holds may be anything: only its seal was checked.
void add_to(int64_t& sum, int64_t more)
{
    if (__builtin_add_overflow(sum, more, &sum))
        throw BakeError("the sums of a shard or checkpoint are beyond all bounds; bake it again");
}

void add(ByteReader& in, PatchSums& sums)
{
    for (TexelSums& texel : sums.texels) {
        texel.count += static_cast<uint32_t>(get_number(in));
        require_few_enough(texel.count);
        for (size_t c = 0; c < 3; ++c) {
            add_to(texel.target[c], get_signed(in));
            add_to(texel.predicted[c], get_signed(in));
        }
        texel.scatter += get_number(in);
    }
    for (uint32_t& crossed : sums.crossed) crossed += static_cast<uint32_t>(get_number(in));
    for (std::array<int64_t, 3>& target : sums.targets)
        for (int64_t& channel : target) add_to(channel, get_signed(in));
    const uint64_t pairs = std::min<uint64_t>(get_number(in), uint64_t{kPatchNodes} * kPatchNodes);
    for (uint64_t k = 0; k < pairs; ++k) {
        const uint64_t key = std::min<uint64_t>(get_number(in), kPatchNodes * kPatchNodes - 1);
        sums.pairs.add(static_cast<uint16_t>(key / kPatchNodes), static_cast<uint16_t>(key % kPatchNodes),
                       get_signed(in));
    }
}

bool is_within(float v, float most)
{
    return std::abs(v) <= most;  // false for what is no number
}
bool is_within(const Vec3& v, float most)
{
    return is_within(v.x, most) && is_within(v.y, most) && is_within(v.z, most);
}

// What the code behind counts on; the mesh lies in the unit sphere.
bool is_sound(const SurfaceBasis& basis)
{
    constexpr float kReach = 1.9f, kMostDensity = 1e6f;
    const SurfaceMesh& mesh = basis.mesh;
    return is_within(mesh.longest_edge, 1e6f) && basis.tone <= ToneCurve::aces &&
           std::all_of(mesh.positions.begin(), mesh.positions.end(),
                       [](const Vec3& p) { return is_within(p, kReach); }) &&
           std::all_of(mesh.normals.begin(), mesh.normals.end(), [](const Vec3& n) { return is_within(n, kReach); }) &&
           std::all_of(basis.densities.begin(), basis.densities.end(),
                       [](float d) { return d >= 0 && is_within(d, kMostDensity); });
}

constexpr uint32_t kBasisTag = 0x42465253, kStateTag = 0x54465253;

}  // namespace

void put(ByteWriter& out, const Vec3& v)
{
    out.put_float(v.x);
    out.put_float(v.y);
    out.put_float(v.z);
}
Vec3 get_vector(ByteReader& in)
{
    const float x = in.get_float(), y = in.get_float();
    return {x, y, in.get_float()};
}

std::vector<uint8_t> encode(const SurfaceBasis& basis)
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
    for (size_t v = 0; v < basis.mesh.positions.size(); ++v) {
        put(out, basis.mesh.positions[v]);
        put(out, basis.mesh.normals[v]);
    }
    for (const SurfaceMesh::Patch& p : basis.mesh.patches)
        for (const uint32_t corner : {p.a, p.b, p.c, p.d}) out.put32(corner);
    for (const float density : basis.densities) out.put_float(density);
    return out.bytes();
}

std::optional<SurfaceBasis> decode_basis(const std::vector<uint8_t>& bytes)
{
    ByteReader in(bytes.data(), bytes.size());
    SurfaceBasis basis = {};
    const uint32_t tag = in.get32(), vertices = in.get32(), patches = in.get32();
    if (tag != kBasisTag || vertices > format::kMaxSurfaceVertices || patches > format::kMaxPatches)
        return std::nullopt;
    basis.mesh.two_sided = in.get32() != 0;
    basis.mesh.longest_edge = in.get_float();
    basis.tone = static_cast<ToneCurve>(in.get32());
    for (double* v : {&basis.loss.missed, &basis.loss.added, &basis.loss.displaced, &basis.sphere.centre[0],
                      &basis.sphere.centre[1], &basis.sphere.centre[2], &basis.sphere.radius})
        *v = in.get_double();
    for (uint32_t v = 0; v < vertices; ++v) {
        basis.mesh.positions.push_back(get_vector(in));
        basis.mesh.normals.push_back(get_vector(in));
    }
    for (uint32_t p = 0; p < patches; ++p) {
        SurfaceMesh::Patch patch = {};
        for (uint32_t* corner : {&patch.a, &patch.b, &patch.c, &patch.d}) {
            *corner = in.get32();
            if (*corner >= vertices && (corner != &patch.d || *corner != SurfaceMesh::kNone)) return std::nullopt;
        }
        basis.mesh.patches.push_back(patch);
    }
    for (uint32_t p = 0; p < patches; ++p) basis.densities.push_back(in.get_float());
    if (!is_sound(basis)) return std::nullopt;
    return basis;
}

std::vector<uint8_t> encode(const SurfaceState& state)
{
    ByteWriter out;
    out.put32(kStateTag);
    out.put32(state.batches);
    out.put32(state.wanted);
    out.put32(state.shape.layout.texels);
    out.put64(state.paths);
    put(out, state.expected.texels);
    put(out, state.expected.nodes);
    for (const PatchSums& patch : state.sums.patches()) put(out, patch);
    return out.bytes();
}

bool is_complete(const std::vector<uint8_t>& state)
{
    ByteReader in(state.data(), state.size());
    const uint32_t tag = in.get32(), batches = in.get32();
    return tag == kStateTag && batches == in.get32();
}

bool add_encoded(const std::vector<uint8_t>& bytes, SurfaceState& state)
{
    ByteReader in(bytes.data(), bytes.size());
    const uint32_t tag = in.get32(), batches = in.get32();
    in.get32();  // what is wanted
    if (tag != kStateTag || in.get32() != state.shape.layout.texels) return false;
    state.batches += batches;
    state.paths += in.get64();
    const bool same_texels = get(in, state.expected.texels, !state.has_pilot);
    if (!get(in, state.expected.nodes, !state.has_pilot) || !same_texels) return false;
    state.has_pilot = true;
    for (PatchSums& patch : state.sums.patches()) add(in, patch);
    return true;
}

}  // namespace lumi::baker
