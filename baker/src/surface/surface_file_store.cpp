// SPDX-License-Identifier: MIT
#include "surface/surface_file_store.h"

#include <algorithm>

#include "util/byte_stream.h"

namespace lumi::baker
{
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
    return newest_.turn != 0 && file_.read(state_block(newest_), bytes);
}

void SurfaceFileStore::write_state(const std::vector<uint8_t>& bytes)
{
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
