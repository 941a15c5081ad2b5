// SPDX-License-Identifier: MIT
#include "surface/surface_file_store.h"

#include <algorithm>
#include <cmath>

#include "lumi/surface/format.h"
#include "mesh/mesh_loss.h"
#include "util/byte_stream.h"
#include "util/gzip.h"

namespace lumi::baker
{

namespace
{

constexpr uint32_t kBasisTag = 0x42475254;

bool is_within(float v, float most)
{
    return std::abs(v) <= most;  // false for what is no number
}
bool is_within(const Vec3& v, float most)
{
    return is_within(v.x, most) && is_within(v.y, most) && is_within(v.z, most);
}

// The code behind counts on this; the mesh lies in the unit sphere.
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
           std::all_of(basis.shadows.shadows.begin(), basis.shadows.shadows.end(),
                       [](const PartShadow& s) {
                           return is_within(s.pivot, kReach) && is_within(s.corner, kReach) &&
                                  is_within(s.across, kReach) && is_within(s.down, kReach);
                       }) &&
           is_sound(basis.gloss, mesh) &&
           std::all_of(basis.see_through.begin(), basis.see_through.end(), [](const SeeThroughTexel& t) {
               const Rgb &light = t.behind, &through = t.through;
               return is_within(t.coverage, 1) && is_within(t.open, 1) &&
                      is_within(Vec3{through.r, through.g, through.b}, 1) &&
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
void fields(Io& io, MovingPart& part)
{
    io(part.name, part.slides, part.light_stays, part.axis, part.pivot, part.from, part.to, part.first_patch);
}
template <class Io>
void fields(Io& io, PatchMesh& mesh)
{
    io(mesh.longest_edge, mesh.positions, mesh.normals, mesh.patches, mesh.see_through_patches, mesh.has_panes,
       mesh.is_matt, mesh.is_in_drawing_order, mesh.parts);
    const size_t vertices = mesh.positions.size();
    io.require(vertices <= detail::format::kMaxSurfaceVertices && mesh.patches.size() <= detail::format::kMaxPatches);
    io.require(mesh.normals.size() == vertices && mesh.see_through_patches <= mesh.patches.size() &&
               mesh.is_in_drawing_order <= 1 && mesh.has_panes <= 1 && mesh.is_matt <= 1 &&
               mesh.parts.size() <= detail::format::kMaxParts);
    for (uint32_t k = 0; k < mesh.parts.size(); ++k)
        io.require(mesh.first_patch(k) <= mesh.parts[k].first_patch &&
                   mesh.parts[k].first_patch <= mesh.opaque_patches());
    for (const PatchMesh::Patch& p : mesh.patches)
        io.require(std::max({p.a, p.b, p.c}) < vertices && (p.d < vertices || p.d == PatchMesh::kNone));
}
template <class Io>
void fields(Io& io, FitBasis& basis)
{
    uint32_t tag = kBasisTag;
    io(tag, basis.mesh, basis.densities, basis.loss, basis.tone, basis.sphere.centre, basis.sphere.radius,
       basis.see_through, basis.shadows, basis.ground, basis.gloss);
    for (const PartShadow& shadow : basis.shadows.shadows) io.require(shadow.part < basis.mesh.parts.size());
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

namespace
{

constexpr uint32_t kSizeNumber = 0, kBasisNumber = 1, kFirstPlaceNumber = 2, kStateNumber = 4;
constexpr Block kSizeBlock = {kHeadBytes, kSizeNumber, 8};
constexpr uint64_t kPlaceBytes = 24;

std::vector<uint8_t> numbers(std::initializer_list<uint64_t> values)
{
    ByteWriter out;
    for (const uint64_t v : values) out.put64(v);
    return out.bytes();
}

}  // namespace

Block SurfaceFileStore::basis_block() const
{
    return {kSizeBlock.end(), kBasisNumber, basis_size_};
}

Block SurfaceFileStore::place_block(uint64_t turn) const
{
    const Block first = {basis_block().end(), kFirstPlaceNumber, kPlaceBytes};
    return turn % 2 == 0 ? first : Block{first.end(), kFirstPlaceNumber + 1, kPlaceBytes};
}

Block SurfaceFileStore::state_block(const Place& place) const
{
    return {place.offset, kStateNumber, place.size};
}

std::optional<FitBasis> SurfaceFileStore::read_basis()
{
    std::vector<uint8_t> bytes;
    if (!file_.read(kSizeBlock, bytes)) return std::nullopt;
    basis_size_ = ByteReader(bytes.data(), bytes.size()).get64();
    return file_.read(basis_block(), bytes) ? decode_basis(bytes) : std::nullopt;
}

void SurfaceFileStore::write_basis(const FitBasis& basis)
{
    const std::vector<uint8_t> bytes = encode(basis);
    basis_size_ = bytes.size();
    file_.write(basis_block(), bytes);
    file_.write(kSizeBlock, numbers({basis_size_}));
}

std::optional<SurfaceFileStore::Place> SurfaceFileStore::place(uint64_t turn) const
{
    std::vector<uint8_t> bytes;
    if (!file_.read(place_block(turn), bytes)) return std::nullopt;
    ByteReader in(bytes.data(), bytes.size());
    Place result;
    result.turn = in.get64();
    result.offset = in.get64();
    result.size = in.get64();
    return result;
}

bool SurfaceFileStore::read_state(std::vector<uint8_t>& bytes)
{
    for (uint64_t turn = 0; turn < 2; ++turn) {
        const std::optional<Place> found = place(turn);
        if (found && found->turn > newest_.turn && file_.read(state_block(*found), bytes)) newest_ = *found;
    }
    if (newest_.turn == 0 || !file_.read(state_block(newest_), bytes)) return false;
    std::optional<std::vector<uint8_t>> state = unpacked(bytes);
    if (!state) return false;
    bytes = std::move(*state);
    return true;
}

void SurfaceFileStore::write_state(const std::vector<uint8_t>& state)
{
    const std::vector<uint8_t> bytes = packed(state);
    const uint64_t begin = place_block(1).end();
    Place next = {newest_.turn + 1, begin, bytes.size()};
    if (newest_.turn != 0 && state_block(next).end() > newest_.offset)
        next.offset = std::max(state_block(newest_).end(), begin + 2 * next.size);  // the first place may grow
    file_.write(state_block(next), bytes);
    file_.file().sync();
    file_.write(place_block(next.turn), numbers({next.turn, next.offset, next.size}));
    newest_ = next;
}

}  // namespace lumi::baker
